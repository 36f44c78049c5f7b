#include "measuring/cpu/CpuName.h"

#include <array>
#include <cstring>

#if defined(_MSC_VER) && (defined(_M_X64) || defined(_M_IX86))
#include <intrin.h>
#elif defined(__x86_64__) || defined(__i386__)
#include <cpuid.h>
#endif

namespace dipwright {

namespace {

using CpuRegisters = std::array<unsigned, 4>;

CpuRegisters cpuid([[maybe_unused]] unsigned leaf) {
    CpuRegisters registers{};
#if defined(_MSC_VER) && (defined(_M_X64) || defined(_M_IX86))
    __cpuid(reinterpret_cast<int*>(registers.data()), int(leaf));
#elif defined(__x86_64__) || defined(__i386__)
    __get_cpuid(leaf, &registers[0], &registers[1], &registers[2], &registers[3]);
#endif
    return registers;
}

} // namespace

std::string cpuName() {
    constexpr unsigned firstLeaf = 0x80000002,
                       lastLeaf = 0x80000004; // the brand string takes three leaves
    if (cpuid(0x80000000)[0] < lastLeaf) {
        return "CPU";
    }
    std::array<char, 3 * sizeof(CpuRegisters) + 1> brand{};
    for (unsigned leaf = firstLeaf; leaf <= lastLeaf; ++leaf) {
        const CpuRegisters part = cpuid(leaf);
        std::memcpy(&brand[(leaf - firstLeaf) * sizeof part], part.data(), sizeof part);
    }
    std::string name = brand.data();
    const auto first = name.find_first_not_of(' ');
    const auto last = name.find_last_not_of(' ');
    return first == std::string::npos ? "CPU" : name.substr(first, last - first + 1);
}

} // namespace dipwright
