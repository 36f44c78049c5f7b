// Lists the solvers for the window. Shows their descriptions at once, and shows the list again when
// it is known which solvers can run on this machine. To find this out, a solver must be loaded.
// Loading may wake a GPU or hang, so it runs outside the UI thread.
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
    // Calls `show` at once and again later, on the calling thread. The registry must outlive this
    // object.
    SolverListing(const SolverRegistry& registry, Show show, QObject* parent);
    ~SolverListing() override; // abandons a module that is being loaded

private:
    Show show_;
    CancelToken cancelToken_;
    QThreadPool loader_;
};

} // namespace dipwright
