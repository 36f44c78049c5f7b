#include "pipeline/CachedDip.h"

#include "settings/FilmSettings.h"

#include <QCoreApplication>
#include <QDataStream>
#include <QIODevice>
#include <cmath>
#include <limits>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(DipCache)
};

constexpr double mostMillimetres = 1e6, mostGrown = 1e3;
constexpr double mostRefinement = 50;
constexpr int longestFailure = 1000;

// Reads the values of a stored dip in order and checks each against its range.
class Reader {
public:
    Reader(const QByteArray& bytes, const QString& where) : in_(bytes), where_(where) {
        in_.setVersion(QDataStream::Qt_6_0);
    }

    // Reads one value; refuses NaN.
    template <typename Value>
    Value value(Value least, Value most) {
        Value value{};
        in_ >> value;
        require(value >= least && value <= most);
        return value;
    }
    // Reads `count` values; accepts NaN only if `mayLack` is true.
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
            throw damagedDips(where_);
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

DippedFilm readFilm(Reader& stored, const solver::FilmGrid& grid, bool isotropic) {
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

// Calls `use` for all numbers of an estimate, so that reading and writing use the same order.
template <typename Use>
void eachFigure(SheetChange& change, const Use& use) {
    for (double* figure :
         {&change.distance.minimum, &change.distance.mean, &change.distance.percentile95,
          &change.distance.maximum, &change.painted, &change.paintedOnce}) {
        use(*figure);
    }
}

template <typename Use>
void eachFigure(NumericalErrorEstimate& estimate, const Use& use) {
    eachFigure(estimate.doubleSpacing, use);
    eachFigure(estimate.doubleStep, use);
    for (double* figure : {&estimate.offBy.minimum, &estimate.offBy.mean,
                           &estimate.offBy.percentile95, &estimate.offBy.maximum}) {
        use(*figure);
    }
}

void write(QDataStream& out, NumericalErrorEstimate estimate) {
    eachFigure(estimate, [&](double figure) { out << figure; });
    out << quint32(estimate.pointErrors.size());
    write(out, estimate.pointErrors);
    const QByteArray failure = estimate.failure.toUtf8();
    out << quint32(failure.size());
    out.writeRawData(failure.constData(), int(failure.size()));
}

NumericalErrorEstimate readEstimate(Reader& stored, std::size_t points) {
    NumericalErrorEstimate estimate;
    eachFigure(estimate, [&](double& figure) { figure = stored.value(0.0, mostMillimetres); });
    const auto count = stored.value<quint32>(0, quint32(points));
    stored.require(count == 0 || count == points);
    estimate.pointErrors = stored.floats(count, 0, mostMillimetres, true);
    estimate.failure = stored.text(longestFailure);
    stored.require(estimate.failure.isEmpty() == (count > 0));
    return estimate;
}

} // namespace

Error damagedDips(const QString& where) {
    return {Text::tr("The file of cached dips is damaged and is ignored; the next run in the "
                     "workbench replaces it"),
            where};
}

QByteArray cachedDip(const CachedDip& dip) {
    QByteArray bytes;
    QDataStream out(&bytes, QIODevice::WriteOnly);
    out.setVersion(QDataStream::Qt_6_0);
    out << dip.refinement;
    write(out, dip.film);
    out << quint8(dip.numericalError != nullptr);
    if (dip.numericalError) {
        write(out, *dip.numericalError);
    }
    return bytes;
}

CachedDip readCachedDip(const QByteArray& bytes, const GridOfRefinement& gridOf, bool isotropic,
                        const QString& where) {
    Reader file(bytes, where);
    const auto refinement = file.value(1.0, mostRefinement);
    const solver::FilmGrid grid = gridOf(refinement);
    CachedDip dip{readFilm(file, grid, isotropic), refinement, nullptr};
    if (file.value<quint8>(0, 1) == 1) {
        dip.numericalError =
            std::make_shared<const NumericalErrorEstimate>(readEstimate(file, grid.pointCount()));
    }
    file.end();
    return dip;
}

} // namespace dipwright
