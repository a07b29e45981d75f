// Reads a normal map it has written itself, and is told in one sentence about a file that is not there.

#include <cstdio>
#include <fstream>

#include "core/image/normal_map_reader.h"

namespace {

// A 2 x 1 binary PPM: (0.8, 0, 0.6) and its mirror image.
void write_two_texels(const char* path) {
  std::ofstream file(path, std::ios::binary);
  file << "P6\n2 1\n255\n";
  for (const int value : {230, 128, 204, 26, 128, 204}) file.put(static_cast<char>(value));
}

bool reads_two_texels(const char* path) {
  glint::JobControl control;
  const auto read = glint::read_normal_map(path, {}, control);
  if (!read) {
    std::fprintf(stderr, "%s\n", read.error().message().c_str());
    return false;
  }
  const glint::NormalMap& map = read->map;
  std::printf("%s: s = %.3f and %.3f\n", path, map.texel(0, 0).x, map.texel(1, 0).x);
  return map.width() == 2 && map.height() == 1 && map.texel(0, 0).x > 0.79F && map.texel(1, 0).x < -0.79F;
}

bool names_a_missing_file(const char* path) {
  glint::JobControl control;
  const auto read = glint::read_normal_map(path, {}, control);
  if (read) return false;
  std::printf("%s\n", read.error().message().c_str());
  return read.error().message().find(path) != std::string::npos && !read.error().sentence.empty();
}

}  // namespace

int main() {
  write_two_texels("two_texels.ppm");
  return reads_two_texels("two_texels.ppm") && names_a_missing_file("no_such_file.exr") ? 0 : 1;
}
