// What the processor can do at most, measured: the roof that the film's rates stand under.
#pragma once

namespace dipwright::cli {

struct Ceiling {
    double flopsPerSecond = 0; // single precision; a fused multiply-add counts as two
    double bytesPerSecond = 0; // read and written by a = b + s·c in arrays past every cache
};

// By all threads that may compute, in a few tenths of a second.
Ceiling measuredCeiling();

} // namespace dipwright::cli
