#pragma once
#include <filesystem>
#include <string>

#include "core/confrontation/feature_bank.hpp"

/// Features that a store keeps of runs by one code, so that they are not read twice. Processes may share the store.
namespace asperity {

/// What names the running code, as 16 hexadecimal digits.
std::string code_key();

/// Those gathered in the store by this code; empty where there are none. Throws as read_bank().
FeatureBank read_gathered(const std::filesystem::path& store);

/// Adds the runs to those in the store. Throws Error(output).
void add_gathered(const std::filesystem::path& store, const FeatureBank& more);

/// Whether this code has given the golden features of the bank with these bytes before, by a note in the store.
bool golden_noted(const std::filesystem::path& store, const std::string& bank_sha256);
void note_golden(const std::filesystem::path& store, const std::string& bank_sha256);

}  // namespace asperity
