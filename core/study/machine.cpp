#include <fstream>
#include <string>
#include <thread>

#include "core/study/study.h"

namespace glint {

std::string machine_name() {
  const std::string cores = std::to_string(std::thread::hardware_concurrency()) + " threads";
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (!line.starts_with("model name")) continue;
    const std::size_t colon = line.find(": ");
    if (colon != std::string::npos) return line.substr(colon + 2) + ", " + cores;
  }
  return "unknown processor, " + cores;
}

std::string instruction_set() {
#if defined(__AVX512F__)
  return "avx512";
#elif defined(__AVX2__)
  return "avx2";
#elif defined(__SSE4_2__)
  return "sse4";
#else
  return "scalar";
#endif
}

}  // namespace glint
