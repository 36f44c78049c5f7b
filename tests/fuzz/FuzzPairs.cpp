// Fuzzes the table of place pairs on two photos, and the camera fit. For an accepted table, the
// fit's figures must be finite.
#include "base/Error.h"
#include "inspection/PartViewFiles.h"

#include <cmath>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    const QByteArray bytes(reinterpret_cast<const char*>(data), qsizetype(size));
    try {
        const auto pairs = dipwright::readPairs(bytes, 2, QStringLiteral("x"));
        const dipwright::PartFigures figures =
            dipwright::fitPartCamera(pairs, 2, {400, 300}, QStringLiteral("x")).figures;
        if (!std::isfinite(figures.meanPixels + figures.deviationPixels + figures.percentile95)) {
            std::abort();
        }
    } catch (const dipwright::Error&) {
    }
    return 0;
}
