#include "core/image/jpeg_check.h"

#include <fstream>
#include <streambuf>

namespace glint {
namespace {

using Traits = std::char_traits<char>;

constexpr int k_marker_prefix = 0xff;
constexpr int k_end_of_image = 0xd9;

// The bytes of a file one by one; -1 at its end.
class ByteReader {
 public:
  explicit ByteReader(std::streambuf& buffer) : buffer_(buffer) {}

  int next() {
    const Traits::int_type read = buffer_.sbumpc();
    return Traits::eq_int_type(read, Traits::eof()) ? -1 : static_cast<unsigned char>(Traits::to_char_type(read));
  }

  bool skip(int count) {
    for (int k = 0; k < count; ++k) {
      if (next() < 0) return false;
    }
    return true;
  }

 private:
  std::streambuf& buffer_;
};

// The code of the next marker, past whatever stands before it; -1 at the end of the file. In entropy-coded data FF 00
// is a data byte and FF D0 … D7 are restarts, which belong to the scan.
int next_marker(ByteReader& bytes) {
  int byte = bytes.next();
  while (byte >= 0) {
    if (byte != k_marker_prefix) {
      byte = bytes.next();
      continue;
    }
    while (byte == k_marker_prefix) byte = bytes.next();
    const bool restart = byte >= 0xd0 && byte <= 0xd7;
    if (byte != 0 && !restart) return byte;
  }
  return -1;
}

bool stands_alone(int marker) {
  return marker == 0x01 || marker == 0xd8;
}

}  // namespace

bool jpeg_reaches_its_end(const std::filesystem::path& path) {
  std::filebuf file;
  if (file.open(path, std::ios::in | std::ios::binary) == nullptr) return false;
  ByteReader bytes(file);
  for (int marker = next_marker(bytes); marker >= 0; marker = next_marker(bytes)) {
    if (marker == k_end_of_image) return true;
    if (stands_alone(marker)) continue;
    const int high = bytes.next();
    const int low = bytes.next();
    if (high < 0 || low < 0) return false;
    const int length = high << 8 | low;
    if (length < 2) continue;  // damaged; the next marker decides
    if (!bytes.skip(length - 2)) return false;
  }
  return false;
}

}  // namespace glint
