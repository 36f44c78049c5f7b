// Fuzzes the reader of a cached dip of a small film, and lays the film on a ball, as happens when a
// project is opened. An accepted dip must be written back as the same bytes.
#include "base/Error.h"
#include "dip/Dip.h"
#include "dip/LaidFilm.h"
#include "geometry/Shapes.h"
#include "pipeline/CachedDip.h"

#include <algorithm>
#include <cstdlib>

namespace {

using namespace dipwright;

std::shared_ptr<const PosedBody> ball() {
    return std::make_shared<const PosedBody>(posedBody(sphereMesh(5, 6, 8), Immersion{}));
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    const QByteArray bytes(reinterpret_cast<const char*>(data), qsizetype(size));
    static const auto body = ball();
    const ProcessSettings process;
    try {
        // This is the film of fuzz-seeds.
        const auto gridOf = [](double) { return solver::FilmGrid{8, 6, 14, 10}; };
        CachedDip dip = readCachedDip(bytes, gridOf, true, QStringLiteral("x"));
        if (cachedDip(dip) != bytes) {
            std::abort();
        }
        if (isStable(dip.film, dipTravel(process, *body))) {
            layFilm(body, std::move(dip.film), process);
        }
    } catch (const Error&) {
    }
    return 0;
}
