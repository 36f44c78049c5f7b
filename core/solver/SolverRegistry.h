// Finding, judging and loading solver plugins.
//
// A plugin is a loadable module with a metadata file of the same base name beside it:
//   pbd-cpu.json   {"format":"dipwright-solver","interface":2,"id":"pbd-cpu","name":…,"version":…,
//                   "device":"cpu|gpu","vendor":…,"module":"pbd-cpu.so","priority":10}
// The metadata is read before any of the module's code runs; a module is loaded when first asked
// for.
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
    QString deviceKind; // "cpu" or "gpu", as the description says
    QString device;     // in words once the module is loaded, until then the kind
    QString modulePath, metadataPath;
    int priority = 0; // −1000 … 1000: "auto" takes the available one with the highest
    bool available = false;
    QString reason; // a sentence, where not available
};

class SolverRegistry {
public:
    // The folders searched, in this order: those that come with the program,
    // DIPWRIGHT_PLUGIN_PATH, the user's plugin folder. Of two plugins with one id the first has it,
    // the other is found by the id with -2 behind.
    static QStringList standardFolders();

    // Modules in the folders `shipped` are loaded into this process and watched (WatchedSolver.h);
    // each of the others, and of these any that has crashed or hung before, runs in one of its own
    // (OutOfProcessSolver.h). The others are refused where others than the user can write to them.
    explicit SolverRegistry(const QStringList& folders = standardFolders(),
                            const QStringList& shipped = shippedPluginFolders());
    ~SolverRegistry();
    SolverRegistry(const SolverRegistry&) = delete;
    SolverRegistry& operator=(const SolverRegistry&) = delete;

    // A module that takes long to be loaded in a process of its own can be left by the switch: then
    // Cancelled is thrown, and it is loaded anew when it is next asked for.

    // All plugins found, sorted by id, as their descriptions have them: none is loaded for it, so
    // that those that may run are not told as available yet.
    const std::vector<SolverInfo>& described() const;
    // The same, each loaded far enough to know whether it can run here.
    std::vector<SolverInfo> solvers(const CancelToken& cancelToken = {}) const;
    // The module of `id`, or of the best available one for "auto", checked (CheckedSolver.h); those
    // that would not be taken either way are not loaded for it. Throws Error with the reason. Lives
    // as long as the registry.
    const solver::SolverModule& module(const QString& id,
                                       const CancelToken& cancelToken = {}) const;
    // Of the same solver as module(id).
    SolverInfo info(const QString& id, const CancelToken& cancelToken = {}) const;
    // The plugin `id` whether or not it can run here; nothing where none is found.
    std::optional<SolverInfo> found(const QString& id, const CancelToken& cancelToken = {}) const;

private:
    struct Data;
    std::unique_ptr<Data> data_;
};

} // namespace dipwright
