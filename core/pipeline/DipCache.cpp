#include "pipeline/DipCache.h"

#include "base/Bytes.h"
#include "base/ProgramName.h"
#include "base/Sha256.h"
#include "dip/Dip.h"
#include "dip/FilmUnderBody.h"
#include "disk/AtomicFile.h"
#include "disk/ZipWriter.h"
#include "model/ModelHash.h"
#include "pipeline/CachedDip.h"
#include "pipeline/SolverChoice.h"
#include "project/ZipReader.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QRegularExpression>
#include <algorithm>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(DipCache)
};

// Version of the cache. Raise it if the dips or their storage format change within one version of
// the program.
constexpr quint32 keptVersion = 13;
constexpr int mostDips = 1000;
constexpr qint64 entryBytes = 256; // upper limit of the zip's overhead per entry

// Returns a hash of what marks can name: the material of each triangle, and the materials' names.
QString materialsHash(const TexturedMesh& model) {
    Sha256 hash;
    hash.add(bytesOf(model.material));
    for (const Material& material : model.materials) {
        hash.add(material.name.toUtf8());
        hash.add(QByteArrayView("\0", 1));
    }
    return QString::fromLatin1(hash.result().toHex());
}

// Computes each dip's key: a hash of everything that the dip depends on (DipInputs), including the
// versions of program and solver.
class CacheKeys {
public:
    explicit CacheKeys(const Project& project) {
        const QJsonObject values = toJson(project);
        QJsonObject process = values[QLatin1String("process")].toObject();
        process.remove(
            QStringLiteral("solver")); // this may be "auto"; the key has the chosen solver
        common_ = {{QStringLiteral("kept"), int(keptVersion)},
                   {QStringLiteral("program"), programVersion()},
                   {QStringLiteral("mesh"), meshHash(project.model)},
                   {QStringLiteral("film"), values[QLatin1String("film")]},
                   {QStringLiteral("process"), process},
                   {QStringLiteral("field"), project.fieldResolution}};
        if (isRefinable(project.film)) { // RefinementInputs
            const QJsonObject tolerance = values[QLatin1String("tolerance")].toObject();
            for (const char* key : {"limits_mm", "marks"}) {
                common_[QLatin1String(key)] = tolerance[QLatin1String(key)];
            }
            common_[QStringLiteral("masks")] = values[QLatin1String("masks")];
            common_[QStringLiteral("materials")] = materialsHash(*project.model);
        }
    }

    QString of(const Immersion& immersion, const SolverInfo& solver) const {
        QJsonArray pose;
        for (const Degrees angle : immersion.rotation) {
            pose.append(angle.value());
        }
        for (const Millimetres offset : immersion.offset) {
            pose.append(offset.value());
        }
        QJsonObject all = common_;
        all[QLatin1String("pose")] = pose;
        if (!immersion.path.isStraightDown()) {
            all[QLatin1String("path")] = pathToJson(immersion);
        }
        all[QLatin1String("solver")] = QJsonArray{solver.id, solver.version};
        return sha256Hex(QJsonDocument(all).toJson(QJsonDocument::Compact));
    }

private:
    QJsonObject common_;
};

// Returns the key in an entry's name, NUMBER-KEY.dip. Entries are numbered by age.
QString keyOf(const QString& entry) {
    static const QRegularExpression pattern(QStringLiteral("^\\d{4}-([0-9a-f]{64})\\.dip$"));
    return pattern.match(entry).captured(1);
}

QString entryOf(int number, const QString& key) {
    return QStringLiteral("%1-%2.dip").arg(number, 4, 10, QLatin1Char('0')).arg(key);
}

// Fills in the cached film and its numerical error.
void restore(ImmersionResult& dip, const Project& project, const QByteArray& bytes,
             const QString& where) {
    const auto gridOf = [&](double refinement) {
        FilmSettings film = project.film;
        film.refinement = refinement;
        if (refinement != 1 && !isRefinable(film)) {
            throw damagedDips(where);
        }
        try {
            return dipGrid(*dip.body, dip.immersion, film, project.process);
        } catch (const Error&) { // too many points
            throw damagedDips(where);
        }
    };
    CachedDip kept =
        readCachedDip(bytes, gridOf, project.film.lattice == solver::Lattice::Isotropic, where);
    dip.refinement = kept.refinement;
    if (!isStable(kept.film, dipTravel(project.process, *dip.body)) ||
        !kept.film.adheresAnywhere()) {
        throw damagedDips(where);
    }
    dip.numericalError = kept.numericalError;
    dip.laid = layFilm(dip.body, std::move(kept.film), project.process);
}

// Returns the contents of a dip cache by key, the oldest first.
std::vector<std::pair<QString, QByteArray>> readAll(const QString& path) {
    std::vector<std::pair<QString, QByteArray>> dips;
    try {
        ZipReader archive(path);
        QStringList entries = archive.names().values();
        entries.sort();
        for (const QString& entry : entries) {
            if (const QString key = keyOf(entry); !key.isEmpty()) {
                dips.emplace_back(key, archive.read(entry));
            }
        }
    } catch (const Error&) {
        dips.clear(); // missing or damaged
    }
    return dips;
}

// Returns the cached dips of the project's immersions; empty if one is missing. Reports every fault
// of the archive as damage.
std::vector<QByteArray> readWanted(const QString& path, const CacheKeys& keys,
                                   const Project& project, const SolverInfo& solver) {
    std::vector<QByteArray> dips;
    try {
        ZipReader archive(path);
        QMap<QString, QString> entries; // entry of each key
        for (const QString& entry : archive.names()) {
            entries.insert(keyOf(entry), entry);
        }
        for (const Immersion& immersion : project.immersions) {
            const QString entry = entries.value(keys.of(immersion, solver));
            if (entry.isEmpty()) {
                return {};
            }
            dips.push_back(archive.read(entry));
        }
    } catch (const Error&) {
        throw damagedDips(path);
    }
    return dips;
}

} // namespace

QString dipCacheFile(const QString& project) {
    const QFileInfo file(project);
    const QString name =
        file.suffix() == QLatin1String("dipw") ? file.completeBaseName() : file.fileName();
    return file.path() + QLatin1Char('/') + name + QStringLiteral(".dips");
}

void cacheDips(const JobResult& result, const QString& project, qint64 most) {
    const QString path = dipCacheFile(project);
    const CacheKeys keys(result.project);
    std::vector<std::pair<QString, QByteArray>> dips = readAll(path);
    bool isNew = false;
    for (const ImmersionResult& dip : result.immersions) {
        if (dip.solver.id != result.chosenSolver) {
            continue;
        }
        const QString key = keys.of(dip.immersion, dip.solver);
        // A failed comparison is tried again next time.
        const bool isCompared = dip.numericalError && dip.numericalError->failure.isEmpty();
        QByteArray bytes = cachedDip(
            {dip.laid->film(), dip.refinement, isCompared ? dip.numericalError : nullptr});
        const auto known = std::find_if(dips.begin(), dips.end(),
                                        [&](const auto& other) { return other.first == key; });
        isNew = isNew || known == dips.end() || known->second != bytes;
        if (known != dips.end()) {
            dips.erase(known);
        }
        dips.emplace_back(key, std::move(bytes));
    }
    if (!isNew) {
        return;
    }
    auto oldest = dips.end();
    for (qint64 bytes = entryBytes; oldest != dips.begin(); --oldest) {
        bytes += std::prev(oldest)->second.size() + entryBytes;
        if (bytes > most || dips.end() - oldest >= mostDips) {
            break;
        }
    }
    dips.erase(dips.begin(), oldest);
    if (dips.empty()) {
        return; // not even one dip fits
    }
    ZipWriter archive;
    for (std::size_t number = 0; number < dips.size(); ++number) {
        archive.add(entryOf(int(number), dips[number].first), dips[number].second,
                    ZipWriter::Packing::Stored);
    }
    if (const QString failure = replaceFile(path, archive.finish()); !failure.isEmpty()) {
        throw Error(Text::tr("The dips cannot be cached: %1").arg(failure), path);
    }
}

std::shared_ptr<const JobResult> cachedDips(const Project& project, const SolverRegistry& registry,
                                            const QString& path, const Progress& progress) {
    if (!project.model || !QFileInfo::exists(dipCacheFile(path))) {
        return nullptr;
    }
    return cachedDipsOf(project,
                        chooseSolver(project.process.solver, registry, progress.cancelToken).solver,
                        path, progress);
}

std::shared_ptr<const JobResult> cachedDipsOf(const Project& project, const SolverInfo& solver,
                                              const QString& path, const Progress& progress) {
    const QString file = dipCacheFile(path);
    if (!project.model || !QFileInfo::exists(file)) {
        return nullptr;
    }
    auto result = std::make_shared<JobResult>();
    result->project = project;
    result->wantedSolver = project.process.solver;
    result->chosenSolver = solver.id;
    const std::vector<QByteArray> kept = readWanted(file, CacheKeys(project), project, solver);
    for (std::size_t number = 0; number < kept.size(); ++number) {
        progress(double(number) / double(kept.size()), Text::tr("Reading the cached dips"));
        ImmersionResult& dip = result->immersions.emplace_back();
        dip.immersion = project.immersions[number];
        dip.solver = solver;
        dip.inputs.texture.dip = dipInputs(project, number, solver.id);
        dip.body = std::make_shared<const PosedBody>(
            posedBody(project.model->mesh, dip.immersion, project.process));
        restore(dip, project, kept[number], file);
    }
    return kept.empty() ? nullptr : result;
}

std::shared_ptr<const JobResult> usableDips(const Project& project, const SolverRegistry& registry,
                                            const QString& path, const Progress& progress,
                                            const std::function<void(const Error&)>& onDamage) {
    try {
        return cachedDips(project, registry, path, progress);
    } catch (const Error& error) {
        onDamage(error);
        return nullptr;
    }
}

} // namespace dipwright
