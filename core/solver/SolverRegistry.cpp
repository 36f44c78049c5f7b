#include "solver/SolverRegistry.h"

#include "base/Error.h"
#include "base/OneLine.h"
#include "base/ShippedFolders.h"
#include "disk/PlainFile.h"
#include "solver/CheckedSolver.h"
#include "solver/FilePermissions.h"
#include "solver/LoadMarker.h"
#include "solver/LoadModule.h"
#include "solver/ModuleText.h"
#include "solver/OlderModule.h"
#include "solver/OutOfProcessSolver.h"
#include "solver/WatchedSolver.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QStandardPaths>
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <mutex>

namespace dipwright {

namespace {

constexpr qint64 maximumMetadataBytes = 64 * 1024;
constexpr int mostPriority = 1000;

struct Text {
    Q_DECLARE_TR_FUNCTIONS(SolverRegistry)
};

// A plugin, and how far it is loaded.
struct Plugin {
    SolverInfo info;
    bool isShipped = false;                  // comes with the program and is loaded into it
    int builtFor = solver::interfaceVersion; // for which it says it was built
    LoadedModule loaded;                     // into this process; or nothing
    // The module that a WatchedSolver or its own process contains.
    std::unique_ptr<solver::SolverModule> inner;
    std::unique_ptr<solver::SolverModule> module; // checks the answers of `inner`
    bool isLoaded = false; // true also if the plugin was refused; it is not loaded again
};

QString requiredText(const QJsonObject& metadata, const char* key) {
    QString text = oneLine(metadata[QLatin1String(key)].toString()).trimmed();
    if (text.isEmpty() || text.size() > 200) {
        throw Refusal(Text::tr("Its description has no valid \"%1\"").arg(QLatin1String(key)));
    }
    return text;
}

QJsonObject readJson(const QString& path) {
    QFile file(path);
    if (const QString failure = openToRead(file); !failure.isEmpty()) {
        throw Refusal(Text::tr("Its description cannot be read: %1").arg(failure));
    }
    const QByteArray bytes = file.read(maximumMetadataBytes + 1);
    if (bytes.size() > maximumMetadataBytes) {
        throw Refusal(Text::tr("Its description file is too large"));
    }
    QJsonParseError error;
    const QJsonDocument document = QJsonDocument::fromJson(bytes, &error);
    if (error.error != QJsonParseError::NoError) {
        throw Refusal(Text::tr("Its description is not valid JSON: %1").arg(error.errorString()));
    }
    return document.object();
}

// Returns the priority by which "auto" chooses; 0 if the plugin gives none.
int priorityOf(const QJsonValue& value) {
    const int priority = value.toInt(value.isUndefined() ? 0 : std::numeric_limits<int>::max());
    if (std::abs(std::int64_t(priority)) > mostPriority) {
        throw Refusal(Text::tr("The \"priority\" in its description has to be a whole number from "
                               "-%1 to %1")
                          .arg(mostPriority));
    }
    return priority;
}

// Returns the version for which the plugin was built.
int interfaceOf(const QJsonObject& metadata) {
    const int version = metadata[QLatin1String("interface")].toInt(-1);
    if (version < oldestInterface || version > solver::interfaceVersion) {
        throw Refusal(Text::tr("It was built for solver interface %1, but this program has %2 to "
                               "%3; get the plugin for this version of the program, or build it "
                               "again")
                          .arg(version)
                          .arg(oldestInterface)
                          .arg(solver::interfaceVersion));
    }
    return version;
}

// Fills in the metadata as far as it is valid.
void readMetadata(Plugin& plugin) {
    SolverInfo& info = plugin.info;
    const QJsonObject metadata = readJson(info.metadataPath);
    if (metadata[QLatin1String("format")].toString() != QLatin1String("dipwright-solver")) {
        throw Refusal(Text::tr("Its description file does not describe a solver"));
    }
    static const QRegularExpression validId(QStringLiteral("^[a-z0-9][a-z0-9-]{0,63}$"));
    const QString id = requiredText(metadata, "id");
    if (!validId.match(id).hasMatch() || id == QLatin1String("auto")) {
        throw Refusal(Text::tr("Its id may contain only lower-case letters, digits and hyphens"));
    }
    info.id = id;
    info.name = requiredText(metadata, "name");
    info.version = requiredText(metadata, "version");
    info.deviceKind = info.device = requiredText(metadata, "device");
    info.vendor = requiredText(metadata, "vendor");
    info.priority = priorityOf(metadata[QLatin1String("priority")]);
    plugin.builtFor = interfaceOf(metadata);
    const QString module = requiredText(metadata, "module");
    if (QFileInfo(module).fileName() != module) {
        throw Refusal(Text::tr("Its module must be in the same folder as its description; give the "
                               "file's name without a "
                               "path"));
    }
    // The link's target is checked, remembered and loaded, even if the link changes later.
    const QFileInfo file(QFileInfo(info.metadataPath).dir().filePath(module));
    info.modulePath = file.canonicalFilePath();
    if (!file.isFile() || info.modulePath.isEmpty()) {
        throw Refusal(Text::tr("Its module %1 is missing").arg(module));
    }
}

void refuseCrashed(const QString& modulePath) {
    if (qEnvironmentVariableIsSet("DIPWRIGHT_RETRY_SOLVERS")) {
        forgetCrashes(modulePath);
    }
    if (crashesOf(modulePath) > crashesAllowed) {
        throw Refusal(Text::tr("It has crashed twice; replace it, or set "
                               "DIPWRIGHT_RETRY_SOLVERS=1 to try it again"));
    }
}

// Throws Refusal if other users can change the plugin's files: they could then decide what code
// this program runs.
void refuseOthersFolder(const SolverInfo& info) {
    const QString folder = QFileInfo(info.metadataPath).path();
    for (const QString& path : {folder, info.metadataPath, info.modulePath}) {
        if (const QString open = writableByOthers(path); !open.isEmpty()) {
            throw Refusal(
                Text::tr("Other users can write to %1; remove that permission, or move the plugin")
                    .arg(open));
        }
    }
}

void loadShipped(Plugin& plugin) {
    const LoadMarker marker(plugin.info.modulePath);
    plugin.loaded = loadModule(plugin.info.modulePath, plugin.builtFor);
    plugin.inner = watchedSolver(*plugin.loaded.module, plugin.info.modulePath);
    plugin.module = checkedSolver(*plugin.inner);
}

void loadContained(Plugin& plugin, const CancelToken& cancelToken) {
    // Anyone who could replace a module in the program's own folders could also replace the
    // program. Besides, if root unpacks an archive, these folders belong to the person who packed
    // it.
    if (!plugin.isShipped) {
        refuseOthersFolder(plugin.info);
    }
    plugin.inner = outOfProcessSolver(plugin.info.modulePath, plugin.builtFor, cancelToken);
    plugin.module = checkedSolver(*plugin.inner);
}

void load(Plugin& plugin, const CancelToken& cancelToken) {
    if (plugin.isLoaded) {
        return;
    }
    try {
        refuseCrashed(plugin.info.modulePath);
        const bool isTrusted = plugin.isShipped && crashesOf(plugin.info.modulePath) == 0;
        isTrusted ? loadShipped(plugin) : loadContained(plugin, cancelToken);
        if (*plugin.module->device() != 0) {
            plugin.info.device = QString::fromUtf8(plugin.module->device());
        }
        plugin.info.available = true;
    } catch (const Refusal& refusal) {
        plugin.info.reason = oneLine(refusal.reason());
    }
    plugin.isLoaded = true;
}

Plugin foundPlugin(const QFileInfo& metadataFile) {
    Plugin plugin;
    plugin.info.id = plugin.info.name = moduleText(metadataFile.completeBaseName());
    plugin.info.metadataPath = metadataFile.absoluteFilePath();
    try {
        readMetadata(plugin);
    } catch (const Refusal& refusal) {
        plugin.info.reason = oneLine(refusal.reason());
        plugin.isLoaded = true;
    }
    return plugin;
}

QStringList canonical(const QStringList& folders) {
    QStringList places;
    for (const QString& folder : folders) {
        places << QFileInfo(folder).canonicalFilePath();
    }
    places.removeAll(QString()); // folders that do not exist
    places.removeDuplicates();
    return places;
}

// Returns an id that no plugin has. The first plugin with an id keeps it; later ones get another id
// by which they can be chosen.
QString freeId(const QString& id, const std::vector<Plugin>& plugins) {
    const auto isTaken = [&](const QString& wanted) {
        return std::any_of(plugins.begin(), plugins.end(),
                           [&](const Plugin& plugin) { return plugin.info.id == wanted; });
    };
    QString free = id;
    for (int number = 2; isTaken(free); ++number) {
        free = QStringLiteral("%1-%2").arg(id).arg(number);
    }
    return free;
}

std::vector<Plugin> foundPlugins(const QStringList& folders, const QStringList& shipped) {
    std::vector<Plugin> plugins;
    for (const QString& folder : canonical(folders)) {
        const QFileInfoList files = QDir(folder).entryInfoList(
            {QStringLiteral("*.json")}, QDir::Files | QDir::Readable, QDir::Name);
        for (const QFileInfo& file : files) {
            Plugin plugin = foundPlugin(file);
            plugin.isShipped = canonical(shipped).contains(folder);
            plugin.info.id = freeId(plugin.info.id, plugins);
            plugins.push_back(std::move(plugin));
        }
    }
    std::sort(plugins.begin(), plugins.end(),
              [](const Plugin& a, const Plugin& b) { return a.info.id < b.info.id; });
    return plugins;
}

} // namespace

struct SolverRegistry::Data {
    std::mutex mutex; // modules are loaded at the first request, by any thread
    std::vector<Plugin> plugins;
    std::vector<SolverInfo> described; // never changes

    Plugin& plugin(const QString& id, const CancelToken& cancelToken);
    Plugin& best(const CancelToken& cancelToken);
    Plugin& named(const QString& id, const CancelToken& cancelToken);
    std::vector<Plugin*> byPriority();
};

// Returns the loaded plugin of `id`. Throws Error if it cannot be used.
Plugin& SolverRegistry::Data::plugin(const QString& id, const CancelToken& cancelToken) {
    return id == QLatin1String("auto") ? best(cancelToken) : named(id, cancelToken);
}

// Returns the plugins with the highest priority first. Equal priorities keep their order.
std::vector<Plugin*> SolverRegistry::Data::byPriority() {
    std::vector<Plugin*> sorted;
    for (Plugin& plugin : plugins) {
        sorted.push_back(&plugin);
    }
    std::stable_sort(sorted.begin(), sorted.end(), [](const Plugin* a, const Plugin* b) {
        return a->info.priority > b->info.priority;
    });
    return sorted;
}

// Stops at the first plugin that can run, because each of the others may take long to load, or
// hang.
Plugin& SolverRegistry::Data::best(const CancelToken& cancelToken) {
    QStringList reasons;
    for (Plugin* plugin : byPriority()) {
        load(*plugin, cancelToken);
        if (plugin->module) {
            return *plugin;
        }
        reasons << QStringLiteral("%1: %2").arg(plugin->info.id, plugin->info.reason);
    }
    throw Error(Text::tr("No solver can run here; install one or set DIPWRIGHT_PLUGIN_PATH"),
                reasons.isEmpty() ? Text::tr("no plugin was found") : reasons.join(u"; "));
}

Plugin& SolverRegistry::Data::named(const QString& id, const CancelToken& cancelToken) {
    const auto found = std::find_if(plugins.begin(), plugins.end(),
                                    [&](const Plugin& plugin) { return plugin.info.id == id; });
    if (found == plugins.end()) {
        QStringList ids{QStringLiteral("auto")};
        for (const Plugin& plugin : plugins) {
            ids << plugin.info.id;
        }
        throw Error(Text::tr("There is no such solver; choose one of %1").arg(ids.join(u", ")), id);
    }
    load(*found, cancelToken);
    if (!found->module) {
        throw Error(Text::tr("This solver cannot be used: %1").arg(found->info.reason), id);
    }
    return *found;
}

QStringList SolverRegistry::standardFolders() {
    QStringList folders = shippedPluginFolders();
    folders << qEnvironmentVariable("DIPWRIGHT_PLUGIN_PATH")
                   .split(QDir::listSeparator(), Qt::SkipEmptyParts);
    folders << QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) +
                   QStringLiteral("/plugins");
    return folders;
}

SolverRegistry::SolverRegistry(const QStringList& folders, const QStringList& shipped)
    : data_(std::make_unique<Data>()) {
    data_->plugins = foundPlugins(folders, shipped);
    for (const Plugin& plugin : data_->plugins) {
        data_->described.push_back(plugin.info);
    }
}

SolverRegistry::~SolverRegistry() = default;

const std::vector<SolverInfo>& SolverRegistry::described() const {
    return data_->described;
}

std::vector<SolverInfo> SolverRegistry::solvers(const CancelToken& cancelToken) const {
    const std::lock_guard lock(data_->mutex);
    std::vector<SolverInfo> infos;
    for (Plugin& plugin : data_->plugins) {
        load(plugin, cancelToken);
        infos.push_back(plugin.info);
    }
    return infos;
}

const solver::SolverModule& SolverRegistry::module(const QString& id,
                                                   const CancelToken& cancelToken) const {
    const std::lock_guard lock(data_->mutex);
    return *data_->plugin(id, cancelToken).module;
}

std::optional<SolverInfo> SolverRegistry::found(const QString& id,
                                                const CancelToken& cancelToken) const {
    const std::lock_guard lock(data_->mutex);
    for (Plugin& plugin : data_->plugins) {
        if (plugin.info.id == id) {
            load(plugin, cancelToken);
            return plugin.info;
        }
    }
    return std::nullopt;
}

SolverInfo SolverRegistry::info(const QString& id, const CancelToken& cancelToken) const {
    const std::lock_guard lock(data_->mutex);
    return data_->plugin(id, cancelToken).info;
}

} // namespace dipwright
