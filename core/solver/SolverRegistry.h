// Finds, checks and loads solver plugins.
//
// A plugin is a loadable module with a metadata file of the same base name beside it:
//   pbd-cpu.json   {"format":"dipwright-solver","interface":4,"id":"pbd-cpu","name":…,"version":…,
//                   "device":"cpu|gpu","vendor":…,"module":"pbd-cpu.so","priority":10}
// The metadata is read before any of the module's code runs. A module is loaded when it is first
// requested.
#pragma once

#include "base/Progress.h"
#include "base/ShippedFolders.h"

#include <dipwright/FilmSolver.h>

#include <QString>
#include <QStringList>
#include <memory>
#include <optional>
#include <vector>

namespace dipwright {

struct SolverInfo {
    QString id, name, version, vendor;
    QString deviceKind; // "cpu" or "gpu", from the metadata
    QString device;     // description for the user once the module is loaded, until then deviceKind
    QString modulePath, metadataPath;
    int priority = 0; // −1000 … 1000: "auto" chooses the available plugin with the highest
    bool available = false;
    QString reason; // a sentence, if not available
};

class SolverRegistry {
public:
    // The folders to search, in this order: the program's own, DIPWRIGHT_PLUGIN_PATH, the user's
    // plugin folder. If two plugins have the same id, the second gets "-2" appended.
    static QStringList standardFolders();

    // Modules in the folders `shipped` are loaded into this process and watched (WatchedSolver.h).
    // All other modules, and shipped ones that crashed or hung before, run in their own process
    // (OutOfProcessSolver.h). Modules that are not shipped are refused if other users can write to
    // them.
    explicit SolverRegistry(const QStringList& folders = standardFolders(),
                            const QStringList& shipped = shippedPluginFolders());
    ~SolverRegistry();
    SolverRegistry(const SolverRegistry&) = delete;
    SolverRegistry& operator=(const SolverRegistry&) = delete;

    // In the functions below, `cancelToken` cancels the loading of a module in its own process.
    // They then throw Cancelled, and the next request loads the module again.

    // Returns all plugins found, sorted by id, as their metadata describes them. Loads no module,
    // so no plugin is marked as available yet.
    const std::vector<SolverInfo>& described() const;
    // Returns all plugins found. Loads each of them far enough to know whether it can run here.
    std::vector<SolverInfo> solvers(const CancelToken& cancelToken = {}) const;
    // Returns the module of the plugin `id`; for "auto", of the best plugin that can run. The
    // module checks the solver's answers (CheckedSolver.h) and lives as long as the registry. Loads
    // only the modules that it needs. Throws Error with the reason if no such plugin can run.
    const solver::SolverModule& module(const QString& id,
                                       const CancelToken& cancelToken = {}) const;
    // Returns information about the solver that module(id) returns.
    SolverInfo info(const QString& id, const CancelToken& cancelToken = {}) const;
    // Returns the plugin `id`, whether or not it can run here; nothing if there is none.
    std::optional<SolverInfo> found(const QString& id, const CancelToken& cancelToken = {}) const;

private:
    struct Data;
    std::unique_ptr<Data> data_;
};

} // namespace dipwright
