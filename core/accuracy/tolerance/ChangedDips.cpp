#include "accuracy/tolerance/ChangedDips.h"

#include "base/Error.h"
#include "dip/Dip.h"

#include <QCoreApplication>

#include <algorithm>

namespace dipwright {
namespace {

constexpr std::size_t dipsAtOnce = 16; // dips in a batch; progress is reported between batches

void requireStable(const DippedFilm& film, double travel, const QString& where) {
    if (!isStable(film, travel)) {
        throw Error(QCoreApplication::translate(
                        "Tolerance", "The simulation became unstable in a dip with deviations; "
                                     "give the film smaller cells or more points"),
                    where);
    }
}

std::shared_ptr<const LaidFilm> laid(const DippedBody& nominal, const ChangedDip& other,
                                     const solver::BatchItem& dip) {
    DippedFilm film = dippedFilm(dip, other.immersion);
    requireStable(film, dip.setup.motion.travel, nominal.immersion.name);
    std::shared_ptr<const PosedBody> body = nominal.body;
    if (other.immersion.rotation != nominal.immersion.rotation ||
        other.immersion.path != nominal.immersion.path) {
        body = std::make_shared<const PosedBody>(
            posedBody(nominal.model.mesh, other.immersion, nominal.process));
    }
    return layFilm(std::move(body), std::move(film), nominal.process);
}

} // namespace

void layDips(const DippedBody& body, const std::vector<ChangedDip>& dips,
             const solver::SolverModule& module, const Progress& progress, const DipLaid& done) {
    for (std::size_t first = 0; first < dips.size(); first += dipsAtOnce) {
        progress(double(first) / double(dips.size()),
                 QCoreApplication::translate("Tolerance", "Simulating dips with deviations"));
        const std::size_t last = std::min(first + dipsAtOnce, dips.size());
        std::vector<solver::BatchItem> batch(last - first);
        for (std::size_t number = first; number < last; ++number) {
            batch[number - first].setup = dips[number].setup;
        }
        simulateDips(batch, module, [&] { return progress.cancelToken.isCancelled(); });
        for (std::size_t number = first; number < last; ++number) {
            progress.cancelToken.throwIfCancelled();
            done(number, laid(body, dips[number], batch[number - first]));
        }
    }
}

} // namespace dipwright
