#include "pipeline/KeptDips.h"

#include "base/Bytes.h"
#include "base/Error.h"
#include "base/ProgramName.h"
#include "dip/FilmUnderBody.h"
#include "disk/ArchiveWriter.h"
#include "disk/WholeFile.h"
#include "pipeline/SolverChoice.h"
#include "project/Archive.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QDataStream>
#include <QFileInfo>
#include <QIODevice>
#include <QJsonArray>
#include <QJsonDocument>
#include <QRegularExpression>
#include <cmath>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(KeptDips)
};

// Raised when a dip of the same inputs comes out otherwise within one version of the program, or is
// stored in another way.
constexpr quint32 keptVersion = 1;
constexpr double mostMillimetres = 1e6, mostGrown = 1e3;
constexpr int longestFailure = 1000;
constexpr int mostDips = 1000;
constexpr qint64 entryBytes = 256; // of a zip, for an entry's name and place, at most

Error damaged(const QString& where) {
    return {Text::tr("The kept dips are damaged and not used; a run makes them again"), where};
}

template <typename Value>
QByteArrayView bytesOf(const std::vector<Value>& values) {
    return {reinterpret_cast<const char*>(values.data()), qsizetype(values.size() * sizeof(Value))};
}

// Of all that a dip depends on (DipInputs), the version of program and solver among it.
class DipKeys {
public:
    explicit DipKeys(const Project& project) {
        QCryptographicHash hash(QCryptographicHash::Sha256);
        hash.addData(bytesOf(project.model->mesh.positions));
        hash.addData(bytesOf(project.model->mesh.triangles));
        const QJsonObject values = toJson(project);
        QJsonObject process = values[QLatin1String("process")].toObject();
        process.remove(QStringLiteral("solver")); // that may be "auto"
        common_ = {{QStringLiteral("kept"), int(keptVersion)},
                   {QStringLiteral("program"), programVersion()},
                   {QStringLiteral("mesh"), QString::fromLatin1(hash.result().toHex())},
                   {QStringLiteral("film"), values[QLatin1String("film")]},
                   {QStringLiteral("process"), process},
                   {QStringLiteral("field"), project.fieldResolution}};
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
        all[QLatin1String("solver")] = QJsonArray{solver.id, solver.version};
        return QString::fromLatin1(
            QCryptographicHash::hash(QJsonDocument(all).toJson(QJsonDocument::Compact),
                                     QCryptographicHash::Sha256)
                .toHex());
    }

private:
    QJsonObject common_;
};

// Entries are NUMBER-KEY.dip, numbered by age.
QString keyOf(const QString& entry) {
    static const QRegularExpression pattern(QStringLiteral("^\\d{4}-([0-9a-f]{64})\\.dip$"));
    return pattern.match(entry).captured(1);
}

QString entryOf(int number, const QString& key) {
    return QStringLiteral("%1-%2.dip").arg(number, 4, 10, QLatin1Char('0')).arg(key);
}

// A dip as it is stored, read one value after the other and held against what it may be.
class StoredDip {
public:
    StoredDip(const QByteArray& bytes, const QString& where) : in_(bytes), where_(where) {
        in_.setVersion(QDataStream::Qt_6_0);
    }

    // NaN is none of them.
    template <typename Value>
    Value value(Value least, Value most) {
        Value value{};
        in_ >> value;
        require(value >= least && value <= most);
        return value;
    }
    // NaN too, where it `mayLack`.
    std::vector<float> floats(std::size_t count, double least, double most, bool mayLack = false) {
        requireLeft(count * sizeof(float));
        in_.setFloatingPointPrecision(QDataStream::SinglePrecision);
        std::vector<float> values(count);
        for (float& value : values) {
            in_ >> value;
            require((value >= float(least) && value <= float(most)) ||
                    (mayLack && std::isnan(value)));
        }
        in_.setFloatingPointPrecision(QDataStream::DoublePrecision);
        return values;
    }
    std::vector<std::uint8_t> bytes(std::size_t count, std::uint8_t most) {
        requireLeft(count);
        std::vector<std::uint8_t> values(count);
        for (std::uint8_t& value : values) {
            quint8 byte = 0;
            in_ >> byte;
            require(byte <= most);
            value = byte;
        }
        return values;
    }
    QString text(int longest) {
        const auto bytes = value<quint32>(0, quint32(longest));
        requireLeft(bytes);
        QByteArray utf8(qsizetype(bytes), '\0');
        require(in_.readRawData(utf8.data(), int(bytes)) == int(bytes));
        return QString::fromUtf8(utf8);
    }
    void end() { require(in_.atEnd()); }
    void require(bool holds) const {
        if (!holds || in_.status() != QDataStream::Ok) {
            throw damaged(where_);
        }
    }

private:
    void requireLeft(std::size_t bytes) {
        require(qint64(bytes) <= in_.device()->bytesAvailable());
    }

    QDataStream in_;
    const QString& where_;
};

void write(QDataStream& out, const std::vector<float>& values) {
    out.setFloatingPointPrecision(QDataStream::SinglePrecision);
    for (const float value : values) {
        out << value;
    }
    out.setFloatingPointPrecision(QDataStream::DoublePrecision);
}

void write(QDataStream& out, const DippedFilm& film) {
    out << quint32(film.positions.size());
    std::vector<float> places;
    for (const Eigen::Vector3f& place : film.positions) {
        places.insert(places.end(), {place.x(), place.y(), place.z()});
    }
    write(out, places);
    for (const solver::PointState state : film.states) {
        out << quint8(state);
    }
    out << quint32(film.marks.size());
    for (const std::uint8_t mark : film.marks) {
        out << quint8(mark);
    }
    out << quint32(film.grown.size());
    write(out, film.grown);
    out << qint64(film.steps) << qint64(film.equilibrium.stepsWithout)
        << film.equilibrium.worstForceLeft << qint64(film.equilibrium.linearIterations)
        << film.wallSeconds;
}

// Of the points of `grid`.
DippedFilm readFilm(StoredDip& stored, const solver::FilmGrid& grid, bool isotropic) {
    constexpr std::uint8_t allMarks = 7, lastState = std::uint8_t(solver::PointState::Trapped);
    constexpr double most = std::numeric_limits<double>::max();
    constexpr qint64 mostSteps = std::numeric_limits<qint64>::max();
    DippedFilm film;
    film.grid = grid;
    film.isotropic = isotropic;
    const std::size_t count = grid.pointCount();
    stored.require(stored.value<quint32>(0, maximumFilmGrid) == count);
    const std::vector<float> places = stored.floats(3 * count, -mostMillimetres, mostMillimetres);
    for (std::size_t point = 0; point < count; ++point) {
        film.positions.emplace_back(places.data() + 3 * point);
    }
    for (const std::uint8_t state : stored.bytes(count, lastState)) {
        film.states.push_back(solver::PointState(state));
    }
    const auto marks = stored.value<quint32>(0, quint32(count));
    stored.require(marks == 0 || marks == count);
    film.marks = stored.bytes(marks, allMarks);
    const auto grown = stored.value<quint32>(0, quint32(count));
    stored.require(grown == 0 || grown == count);
    film.grown = stored.floats(grown, 0, mostGrown);
    film.steps = stored.value<qint64>(0, mostSteps);
    film.equilibrium.stepsWithout = stored.value<qint64>(0, mostSteps);
    film.equilibrium.worstForceLeft = stored.value<double>(0, most);
    film.equilibrium.linearIterations = stored.value<qint64>(0, mostSteps);
    film.wallSeconds = stored.value<double>(0, most);
    return film;
}

// The figures of a change, for reading and writing alike.
template <typename Use>
void eachFigure(SheetChange& change, const Use& use) {
    for (double* figure :
         {&change.distance.minimum, &change.distance.mean, &change.distance.percentile95,
          &change.distance.maximum, &change.painted, &change.paintedOnce}) {
        use(*figure);
    }
}

template <typename Use>
void eachFigure(CertaintyEstimate& estimate, const Use& use) {
    eachFigure(estimate.doubleSpacing, use);
    eachFigure(estimate.doubleStep, use);
    for (double* figure : {&estimate.offBy.minimum, &estimate.offBy.mean,
                           &estimate.offBy.percentile95, &estimate.offBy.maximum}) {
        use(*figure);
    }
}

void write(QDataStream& out, CertaintyEstimate estimate) {
    eachFigure(estimate, [&](double figure) { out << figure; });
    out << quint32(estimate.pointsOffBy.size());
    write(out, estimate.pointsOffBy);
    const QByteArray failure = estimate.failure.toUtf8();
    out << quint32(failure.size());
    out.writeRawData(failure.constData(), int(failure.size()));
}

CertaintyEstimate readEstimate(StoredDip& stored, std::size_t points) {
    CertaintyEstimate estimate;
    eachFigure(estimate, [&](double& figure) { figure = stored.value(0.0, mostMillimetres); });
    const auto count = stored.value<quint32>(0, quint32(points));
    stored.require(count == 0 || count == points);
    estimate.pointsOffBy = stored.floats(count, 0, mostMillimetres, true);
    estimate.failure = stored.text(longestFailure);
    stored.require(estimate.failure.isEmpty() == (count > 0));
    return estimate;
}

QByteArray stored(const ImmersionResult& dip) {
    QByteArray bytes;
    QDataStream out(&bytes, QIODevice::WriteOnly);
    out.setVersion(QDataStream::Qt_6_0);
    write(out, dip.laid->film());
    out << quint8(dip.certainty != nullptr);
    if (dip.certainty) {
        write(out, *dip.certainty);
    }
    return bytes;
}

// Fills in what was kept of the film and its certainty.
void restore(ImmersionResult& dip, const Project& project, const QByteArray& bytes,
             const QString& where) {
    const FilmSettings& settings = project.film;
    const solver::FilmGrid grid =
        isGraded(settings)
            ? filmUnderBody(settings, undersideOf(*dip.body, project.process), dip.immersion.offset)
            : filmGrid(settings);
    StoredDip file(bytes, where);
    DippedFilm film = readFilm(file, grid, settings.lattice == solver::Lattice::Isotropic);
    if (file.value<quint8>(0, 1) == 1) {
        dip.certainty =
            std::make_shared<const CertaintyEstimate>(readEstimate(file, grid.pointCount()));
    }
    file.end();
    file.require(isStable(film, dipTravel(project.process, *dip.body)) &&
                 std::find(film.states.begin(), film.states.end(), solver::PointState::Adhered) !=
                     film.states.end());
    dip.laid = layFilm(dip.body, std::move(film), project.process);
}

// What is in a file of kept dips, by key, the oldest first.
std::vector<std::pair<QString, QByteArray>> readAll(const QString& path) {
    std::vector<std::pair<QString, QByteArray>> dips;
    try {
        ArchiveReader archive(path);
        QStringList entries = archive.names().values();
        entries.sort();
        for (const QString& entry : entries) {
            if (const QString key = keyOf(entry); !key.isEmpty()) {
                dips.emplace_back(key, archive.read(entry));
            }
        }
    } catch (const Error&) {
        dips.clear(); // missing, or not to be saved
    }
    return dips;
}

// Those of the project's immersions; empty where not all of them are there. Whatever is wrong with
// the archive is damage.
std::vector<QByteArray> readWanted(const QString& path, const DipKeys& keys, const Project& project,
                                   const SolverInfo& solver) {
    std::vector<QByteArray> dips;
    try {
        ArchiveReader archive(path);
        QMap<QString, QString> entries; // by key
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
        throw damaged(path);
    }
    return dips;
}

} // namespace

QString keptDipsFile(const QString& project) {
    const QFileInfo file(project);
    const QString name =
        file.suffix() == QLatin1String("dipw") ? file.completeBaseName() : file.fileName();
    return file.path() + QLatin1Char('/') + name + QStringLiteral(".dips");
}

void keepDips(const JobResult& result, const QString& project, qint64 most) {
    const QString path = keptDipsFile(project);
    const DipKeys keys(result.project);
    std::vector<std::pair<QString, QByteArray>> dips = readAll(path);
    bool isNew = false;
    for (const ImmersionResult& dip : result.immersions) {
        if (dip.solver.id != result.chosenSolver) {
            continue;
        }
        const QString key = keys.of(dip.immersion, dip.solver);
        QByteArray bytes = stored(dip);
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
        return; // not even one has room
    }
    ArchiveWriter archive;
    for (std::size_t number = 0; number < dips.size(); ++number) {
        archive.add(entryOf(int(number), dips[number].first), dips[number].second,
                    ArchiveWriter::Packing::Stored);
    }
    if (const QString failure = replaceFile(path, archive.finish()); !failure.isEmpty()) {
        throw Error(Text::tr("The dips cannot be kept: %1").arg(failure), path);
    }
}

std::shared_ptr<const JobResult> keptDips(const Project& project, const SolverRegistry& registry,
                                          const QString& path, const Progress& progress) {
    const QString file = keptDipsFile(path);
    if (!project.model || !QFileInfo::exists(file)) {
        return nullptr;
    }
    auto result = std::make_shared<JobResult>();
    result->project = project;
    result->wantedSolver = project.process.solver;
    const SolverInfo solver = chooseSolver(result->wantedSolver, registry).solver;
    result->chosenSolver = solver.id;
    const std::vector<QByteArray> kept = readWanted(file, DipKeys(project), project, solver);
    for (std::size_t number = 0; number < kept.size(); ++number) {
        progress(double(number) / double(kept.size()), Text::tr("Reading the kept dips"));
        ImmersionResult& dip = result->immersions.emplace_back();
        dip.immersion = project.immersions[number];
        dip.solver = solver;
        dip.inputs.texture.dip = dipInputs(project, number, solver.id);
        dip.body = std::make_shared<const PosedBody>(posedBody(*project.model, dip.immersion));
        restore(dip, project, kept[number], file);
    }
    return kept.empty() ? nullptr : result;
}

} // namespace dipwright
