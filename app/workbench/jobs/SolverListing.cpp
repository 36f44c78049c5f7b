#include "workbench/jobs/SolverListing.h"

namespace dipwright {

SolverListing::SolverListing(const SolverRegistry& registry, Show show, QObject* parent)
    : QObject(parent), show_(std::move(show)) {
    show_(registry.described());
    loader_.setMaxThreadCount(1);
    loader_.start([this, &registry, cancelToken = cancelToken_] {
        try {
            const std::vector<SolverInfo> solvers = registry.solvers(cancelToken);
            QMetaObject::invokeMethod(
                this, [this, solvers] { show_(solvers); }, Qt::QueuedConnection);
        } catch (const Cancelled&) {
            return; // the listing was destroyed
        }
    });
}

SolverListing::~SolverListing() {
    cancelToken_.cancel();
    loader_.waitForDone();
}

} // namespace dipwright
