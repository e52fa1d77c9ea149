#pragma once
#include <string>
#include <string_view>

namespace asperity {

/// SHA-256 of the bytes (FIPS 180-4, Sect. 6.2) as 64 lower-case hexadecimal digits; names configurations and builds.
std::string sha256_hex(std::string_view bytes);

}  // namespace asperity
