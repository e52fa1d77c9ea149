#include "render/text_runs.hpp"

#include "render/text_metrics.hpp"

namespace asperity::render {
namespace {

constexpr double kLoweredSize = 0.76, kLoweredBy = 0.18;  // parts of the line's size
constexpr const char* kOpen = "_{";

struct Piece {
  std::string text;
  bool lowered = false;
};

std::vector<Piece> pieces_of(const std::string& text) {
  std::vector<Piece> pieces;
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t open = text.find(kOpen, at);
    const std::size_t close = open == std::string::npos ? open : text.find('}', open);
    if (close == std::string::npos) break;
    if (open > at) pieces.push_back({text.substr(at, open - at), false});
    if (close > open + 2) pieces.push_back({text.substr(open + 2, close - open - 2), true});
    at = close + 1;
  }
  if (at < text.size()) pieces.push_back({text.substr(at), false});
  return pieces;
}

}  // namespace

std::vector<TextRun> runs_of(const std::string& text, double size, Weight weight) {
  std::vector<TextRun> runs;
  double along = 0;
  for (const Piece& piece : pieces_of(text)) {
    const double own = piece.lowered ? kLoweredSize * size : size;
    runs.push_back({piece.text, own, along, piece.lowered ? kLoweredBy * size : 0});
    if (piece.text.size() < text.size()) along += text_advance(piece.text, own, weight);
  }
  return runs;
}

std::string unmarked(const std::string& text) {
  std::string plain;
  for (const Piece& piece : pieces_of(text)) plain += piece.text;
  return plain;
}

}  // namespace asperity::render
