#include "sheet/page/CodedBoard.h"

#include <cstdint>

namespace dipwright {

bool isDottedSquare(BoardKind kind, int column, int row) {
    // A hash in which every bit of the three numbers affects the lowest bits.
    std::uint32_t bits = std::uint32_t(column) * 73856093U ^ std::uint32_t(row) * 19349663U ^
                         (kind == BoardKind::Film ? 83492791U : 2654435761U);
    for (int round = 0; round < 3; ++round) {
        bits ^= bits >> 15;
        bits *= 0x2c1b3c6dU;
        bits ^= bits >> 12;
    }
    return bits % 8 < 3;
}

} // namespace dipwright
