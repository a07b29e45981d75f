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

}  // namespace glint
