#pragma once
#include <string>
#include <vector>

#include "render/colour_map.hpp"
#include "render/drawing.hpp"
#include "render/range.hpp"

namespace asperity::render {

/// A table of numbers in coloured cells, with a colour bar. Columns' names stand upright over them.
struct MatrixPlot {
  std::string title, caption, rows_title, columns_title, value_label;
  std::vector<std::string> rows, columns;
  std::vector<std::vector<double>> values;      ///< Row by row; NaN: a white cell.
  std::vector<std::vector<std::string>> texts;  ///< In the cells; empty: none.
  std::vector<std::string> row_notes;           ///< Behind the rows; may be empty.
  Range range{0, 1};
  ColourMap map = ColourMap::magma_light_to_dark;
  bool frame_same_names = false;  ///< Of row, before " × " and a strength, and column.
};

/// The picture grows with the number of cells. Throws
/// Error(config) where the sizes of the parts do not go together or there is no cell.
Drawing draw_matrix(const MatrixPlot& plot);

/// What was hidden (rows) against what was named (columns): counts in the cells, coloured by their share of the row;
/// none: a white cell.
MatrixPlot confusion_matrix(const std::vector<std::string>& rows, const std::vector<std::string>& columns,
                            const std::vector<std::vector<double>>& counts);

/// Cosines between directions, -1 to 1.
MatrixPlot cosine_matrix(const std::vector<std::string>& names, const std::vector<std::vector<double>>& cosines);

}  // namespace asperity::render
