// Which solvers there are, for who lists them in the window: at once as they describe themselves,
// and again when each has been loaded far enough to know whether it can run here. That may wake a
// GPU, or hang, and goes on beside the UI thread.
#pragma once

#include "base/Progress.h"
#include "solver/SolverRegistry.h"

#include <QObject>
#include <QThreadPool>
#include <functional>

namespace dipwright {

class SolverListing : public QObject {
    Q_OBJECT

public:
    using Show = std::function<void(const std::vector<SolverInfo>&)>;
    // `show` is called here, and once more later on this thread. The registry must outlive it.
    SolverListing(const SolverRegistry& registry, Show show, QObject* parent);
    ~SolverListing() override; // lets go of a module that is being loaded

private:
    Show show_;
    CancelToken cancelToken_;
    QThreadPool loader_;
};

} // namespace dipwright
