// Measures the colours that sheets put onto bodies. Reads each sheet as another program would,
// carries its pixels forward through the film onto the body, and compares them with the texture
// there:
//   body_colour_bench [dpi=N] [samples=N] [reader=png|gs] [detail] JOB …
// JOB is a project file, or one of the names of the built-in jobs: grey, earth, noise, dark.
// They are spheres that are dipped whole. reader=gs draws the sheet's PDF with Ghostscript.
//
// Prints one line per dip: the share of the painted, unmarked surface within the ink limit whose
// colour is off by at most 2 (CIEDE2000), the mean and the 95th percentile, and the share of the
// surface beyond the limit. `detail` adds lines for ranges of the area stretch J and, for spheres,
// of the angle from the lower pole. Uses nothing of the code that makes sheets (core/texture).
//
// Where film cells are uneven, "J" is ambiguous. The first figures use the area stretch of the
// film's cells; "triangles" are the same figures with the area stretch of each triangle by itself.
#include "Bench.h"
#include "base/Error.h"
#include "base/WideGamut.h"
#include "geometry/Shapes.h"
#include "pipeline/Pipeline.h"
#include "project/ProjectStore.h"
#include "sheet/prepress/SheetFiles.h"

#include <QFile>
#include <QGuiApplication>
#include <QImageReader>
#include <QProcess>
#include <QTemporaryDir>
#include <QTextStream>

#include <algorithm>
#include <cmath>
#include <functional>
#include <lcms2.h>
#include <numbers>
#include <random>

using namespace dipwright;

namespace {

using Light = Eigen::Array3d;

double linearOf(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

// A picture in linear light, in sRGB's or in wide colour's primaries.
struct Picture {
    QImage image;
    bool isWide = false;

    explicit Picture(const QImage& source)
        : image(source.convertToFormat(QImage::Format_RGBA64)), isWide(dipwright::isWide(source)) {}
    Light texel(int x, int y) const {
        const auto* pixel = reinterpret_cast<const quint16*>(image.constScanLine(y)) + 4 * x;
        const double alpha = pixel[3] / 65535.0;
        return alpha * Light(table()[pixel[0]], table()[pixel[1]], table()[pixel[2]]) + 1 - alpha;
    }
    // Interpolates between texels; coordinates repeat.
    Light at(const Eigen::Vector2d& uv) const {
        const double x = (uv.x() - std::floor(uv.x())) * image.width() - 0.5;
        const double y = (1 - uv.y() - std::floor(1 - uv.y())) * image.height() - 0.5;
        const double right = x - std::floor(x), down = y - std::floor(y);
        const auto wrapped = [](double place, int size) {
            return (int(std::floor(place)) % size + size) % size;
        };
        const int x0 = wrapped(x, image.width()), x1 = wrapped(x + 1, image.width());
        const int y0 = wrapped(y, image.height()), y1 = wrapped(y + 1, image.height());
        return (1 - down) * ((1 - right) * texel(x0, y0) + right * texel(x1, y0)) +
               down * ((1 - right) * texel(x0, y1) + right * texel(x1, y1));
    }

private:
    static const std::vector<double>& table() {
        static const std::vector<double> values = [] {
            std::vector<double> made(65536);
            for (std::size_t code = 0; code < made.size(); ++code) {
                made[code] = linearOf(double(code) / 65535);
            }
            return made;
        }();
        return values;
    }
};

cmsCIELab labOf(const Light& light, bool isWide) {
    Eigen::Matrix3d toXyz;
    if (isWide) {
        toXyz << 0.6369580, 0.1446169, 0.1688810, 0.2627002, 0.6779981, 0.0593017, 0, 0.0280727,
            1.0609851;
    } else {
        toXyz << 0.4123908, 0.3575843, 0.1804808, 0.2126390, 0.7151687, 0.0721923, 0.0193308,
            0.1191948, 0.9505322;
    }
    const Eigen::Vector3d xyz = toXyz * light.matrix(), white = toXyz * Eigen::Vector3d::Ones();
    const cmsCIEXYZ place{xyz[0], xyz[1], xyz[2]}, paper{white[0], white[1], white[2]};
    cmsCIELab lab;
    cmsXYZ2Lab(&paper, &lab, &place);
    return lab;
}

// The film at the end of a dip: where each flat place lies on the body, and how far it has grown.
class ForwardFilm {
public:
    ForwardFilm(const ImmersionResult& dip, const SurfaceAppearance& appearance)
        : laid_(*dip.laid), film_(laid_.film()), appearance_(appearance) {
        for (const QImage& texture : appearance.textures) {
            textures_.emplace_back(texture);
        }
        for (std::size_t triangle = 0; triangle < laid_.triangles().size(); ++triangle) {
            const FilmTriangle& corners = laid_.triangles()[triangle];
            const Eigen::Vector3d a = place(corners[0]);
            grown_.push_back((place(corners[1]) - a).cross(place(corners[2]) - a).norm() / 2);
        }
        isWide_ = std::any_of(textures_.begin(), textures_.end(),
                              [](const Picture& picture) { return picture.isWide; });
    }

    // Whether the place is in a painted triangle without marks. Both cells' triangles must be.
    bool isCounted(const FilmPlace& flat) const {
        const std::size_t other = flat.triangle ^ 1U;
        return laid_.contact().painted[flat.triangle] != 0 && laid_.contact().painted[other] != 0 &&
               laid_.marks(flat.triangle) == 0;
    }
    std::optional<FilmPlace> flat(const Eigen::Vector2d& rest) const {
        return laid_.flat(rest.cast<float>());
    }
    SurfacePoint onBody(const FilmPlace& flat) const {
        const Eigen::Vector3d weights = laid_.weights(flat).cast<double>();
        Eigen::Vector3d lies = Eigen::Vector3d::Zero();
        for (int k = 0; k < 3; ++k) {
            lies += weights[k] * place(laid_.triangles()[flat.triangle][std::size_t(k)]);
        }
        return laid_.body().query.closest(lies.cast<float>()).point;
    }
    double triangleStretch(const FilmPlace& flat) const {
        return grown_[flat.triangle] / restArea(film_.grid, flat.triangle);
    }
    double cellStretch(const FilmPlace& flat) const {
        const std::size_t other = flat.triangle ^ 1U;
        return (grown_[flat.triangle] + grown_[other]) /
               (restArea(film_.grid, flat.triangle) + restArea(film_.grid, other));
    }
    // The colour that the body should show at a place.
    Light colourAt(const SurfacePoint& point) const {
        const Material& material = appearance_.materials[appearance_.material[point.triangle]];
        if (material.texture < 0 || !appearance_.hasTextureCoordinates(point.triangle)) {
            const QColor colour = material.colour;
            return {linearOf(colour.redF()), linearOf(colour.greenF()), linearOf(colour.blueF())};
        }
        Eigen::Vector2d uv = Eigen::Vector2d::Zero();
        for (int k = 0; k < 3; ++k) {
            uv += double(point.weights[k]) *
                  appearance_.textureCoordinates[point.triangle][std::size_t(k)].cast<double>();
        }
        return textures_[std::size_t(material.texture)].at(uv);
    }
    // The angle between a place, seen from the body's middle, and the way down, degrees.
    double angle(const SurfacePoint& point) const {
        const TriangleMesh& mesh = laid_.body().mesh;
        const Eigen::Vector3f place = position(mesh, point) - boundingBox(mesh).center();
        return std::acos(std::clamp(double(-place.normalized().y()), -1.0, 1.0)) * 180 /
               std::numbers::pi;
    }
    bool isWide() const { return isWide_; }
    const solver::FilmGrid& grid() const { return film_.grid; }

private:
    Eigen::Vector3d place(std::uint32_t point) const {
        return laid_.contact().places[point].cast<double>();
    }

    const LaidFilm& laid_;
    const DippedFilm& film_;
    const SurfaceAppearance& appearance_;
    std::vector<Picture> textures_;
    std::vector<double> grown_; // area of each film triangle on the body, mm²
    bool isWide_ = false;
};

struct Sample {
    double cell = 0, triangle = 0;      // ΔE by the stretch of cells and of triangles
    double stretch = 1, unevenness = 1; // J of the cell; larger J of its triangles / smaller
    double density = 1;                 // shown density / wanted density, by the cell
    double angle = 0;                   // from the lower pole, degrees
    double area = 0;                    // mm² of body
    bool isWithinLimit = true;
};

double density(const Light& light) {
    return -std::log10(std::max(light.mean(), 1e-6));
}

Light shownThrough(const Light& printed, double stretch) {
    return printed.max(1e-6).pow(1 / stretch);
}

// The sheet as another program sees it.
QImage readSheet(const Sheet& sheet, double dpi, bool useGhostscript) {
    const QTemporaryDir folder;
    const QString path = folder.filePath(useGhostscript ? "sheet.pdf" : "sheet.png");
    QFile file(path);
    file.open(QIODevice::WriteOnly);
    if (!useGhostscript) {
        writeSheetPng(sheet, file);
        file.close();
        QImage image(path);
        const bool wide = image.colorSpace().isValid() &&
                          image.colorSpace().primaries() != QColorSpace::Primaries::SRgb;
        if (wide) { // the file's own space, named as the programs of this project name it
            image.convertTo(QImage::Format_RGBA64);
            image.setColorSpace(wideSpace());
        }
        return image;
    }
    writeSheetPdf(sheet, file);
    file.close();
    const QString picture = folder.filePath(QStringLiteral("page.png"));
    QProcess::execute(QStringLiteral("gs"),
                      {"-q", "-dNOPAUSE", "-dBATCH", "-dSAFER", "-sDEVICE=png16m",
                       QStringLiteral("-r%1").arg(dpi), "-o", picture, path});
    return QImage(picture);
}

std::vector<Sample> samplesOf(const ForwardFilm& film, const Picture& sheet, double limit,
                              int count) {
    constexpr int places = 6; // per side of a pixel
    const solver::FilmGrid& grid = film.grid();
    const double wide = grid.width / sheet.image.width(), deep = grid.depth / sheet.image.height();
    std::mt19937 random(7);
    std::uniform_int_distribution<int> column(0, sheet.image.width() - 1);
    std::uniform_int_distribution<int> row(0, sheet.image.height() - 1);
    const auto restAt = [&](double x, double y) {
        return Eigen::Vector2d(x * wide - grid.width / 2, y * deep - grid.depth / 2);
    };
    const double darkest = std::pow(10, -limit);
    std::vector<Sample> samples;
    for (int n = 0; n < count; ++n) {
        const int x = column(random), y = row(random);
        const auto flat = film.flat(restAt(x + 0.5, y + 0.5));
        if (!flat || !film.isCounted(*flat)) {
            continue;
        }
        Light wanted = Light::Zero();
        for (int place = 0; place < places * places; ++place) {
            const auto near = film.flat(
                restAt(x + (place % places + 0.5) / places, y + (place / places + 0.5) / places));
            wanted += film.colourAt(film.onBody(near ? *near : *flat)) / (places * places);
        }
        const SurfacePoint point = film.onBody(*flat);
        Light printed = sheet.texel(x, y);
        const double triangle = film.triangleStretch(*flat);
        Sample sample;
        sample.stretch = film.cellStretch(*flat);
        sample.unevenness = std::max(triangle / sample.stretch, sample.stretch / triangle);
        sample.area = wide * deep * sample.stretch;
        sample.isWithinLimit = wanted.minCoeff() > darkest &&
                               shownThrough(wanted, 1 / sample.stretch).minCoeff() > darkest &&
                               shownThrough(wanted, 1 / triangle).minCoeff() > darkest;
        const cmsCIELab right = labOf(wanted, film.isWide());
        const auto difference = [&](double stretch) {
            const cmsCIELab shown = labOf(shownThrough(printed, stretch), sheet.isWide);
            return cmsCIE2000DeltaE(&right, &shown, 1, 1, 1);
        };
        sample.cell = difference(sample.stretch);
        sample.triangle = difference(triangle);
        sample.density = density(shownThrough(printed, sample.stretch)) / density(wanted);
        sample.angle = film.angle(point);
        samples.push_back(sample);
    }
    return samples;
}

struct Figures {
    double area = 0, good = 0, mean = 0, percentile95 = 0, density = 0;
};
Figures figuresOf(const std::vector<Sample>& samples, double Sample::*error) {
    std::vector<std::pair<double, double>> errors; // with areas
    Figures figures;
    for (const Sample& sample : samples) {
        errors.emplace_back(sample.*error, sample.area);
        figures.area += sample.area;
        figures.good += sample.*error <= 2 ? sample.area : 0;
        figures.mean += sample.*error * sample.area;
        figures.density += sample.density * sample.area;
    }
    if (figures.area <= 0) {
        return figures;
    }
    std::sort(errors.begin(), errors.end());
    double sum = 0;
    for (const auto& [value, area] : errors) {
        sum += area;
        figures.percentile95 = value;
        if (sum >= 0.95 * figures.area) {
            break;
        }
    }
    figures.good /= figures.area;
    figures.mean /= figures.area;
    figures.density /= figures.area;
    return figures;
}

template <typename Condition>
std::vector<Sample> those(const std::vector<Sample>& samples, const Condition& condition) {
    std::vector<Sample> chosen;
    std::copy_if(samples.begin(), samples.end(), std::back_inserter(chosen), condition);
    return chosen;
}

void printLine(const QString& name, const std::vector<Sample>& samples, double whole,
               QTextStream& out) {
    if (samples.empty()) {
        return;
    }
    const Figures cell = figuresOf(samples, &Sample::cell);
    const Figures triangle = figuresOf(samples, &Sample::triangle);
    out << QStringLiteral("%1 %2 %  within 2: %3 %  mean %4  95th %5  density %6   triangles: "
                          "%7 %  %8\n")
               .arg(name, -28)
               .arg(100 * cell.area / whole, 5, 'f', 1)
               .arg(100 * cell.good, 6, 'f', 2)
               .arg(cell.mean, 0, 'f', 2)
               .arg(cell.percentile95, 0, 'f', 2)
               .arg(cell.density, 0, 'f', 3)
               .arg(100 * triangle.good, 6, 'f', 2)
               .arg(triangle.percentile95, 0, 'f', 2);
    out.flush();
}

// Smooth random numbers in space, 0 … 1: linear interpolation between those of a lattice.
double noiseAt(const Eigen::Vector3d& place, std::uint32_t kind) {
    const Eigen::Vector3d floor = place.array().floor();
    const Eigen::Vector3d inside = place - floor;
    double sum = 0;
    for (int corner = 0; corner < 8; ++corner) {
        std::uint32_t hash = 2166136261U + kind;
        double weight = 1;
        for (int axis = 0; axis < 3; ++axis) {
            const int step = corner >> axis & 1;
            weight *= step == 1 ? inside[axis] : 1 - inside[axis];
            hash = (hash ^ std::uint32_t(int(floor[axis]) + step + 1000)) * 16777619U;
            hash ^= hash >> 15;
        }
        hash *= 2246822519U;
        sum += weight * double(hash >> 8) / double(1U << 24);
    }
    return sum;
}

// A map of the world, from the colours (sRGB) at places of a ball with the radius 1.
QImage map(const std::function<Light(const Eigen::Vector3d&)>& colour) {
    QImage picture(2048, 1024, QImage::Format_RGBA8888);
    for (int y = 0; y < picture.height(); ++y) {
        const double up = (0.5 - (y + 0.5) / picture.height()) * std::numbers::pi;
        for (int x = 0; x < picture.width(); ++x) {
            const double round = 2 * std::numbers::pi * (x + 0.5) / picture.width();
            const Light light = colour(
                {std::cos(up) * std::cos(round), std::sin(up), std::cos(up) * std::sin(round)});
            picture.setPixelColor(
                x, y, QColor::fromRgbF(float(light[0]), float(light[1]), float(light[2])));
        }
    }
    return picture;
}

Light earth(const Eigen::Vector3d& place) {
    double height = -0.5;
    for (int octave = 0; octave < 5; ++octave) {
        height +=
            noiseAt(place * 2 * std::exp2(octave), std::uint32_t(octave)) / std::exp2(octave + 1);
    }
    return std::abs(place.y()) > 0.96 ? Light(0.95, 0.96, 0.98)
           : height > 0               ? Light(0.4 + height, 0.5, 0.25)
                                      : Light(0.15, 0.4 + height / 2, 0.65 + height / 2);
}

std::optional<QImage> builtIn(const QString& name) {
    if (name == QLatin1String("grey")) {
        return map([](const auto&) { return Light(0.6, 0.6, 0.6); });
    }
    if (name == QLatin1String("earth")) {
        return map(earth);
    }
    if (name == QLatin1String("noise")) {
        return map([](const Eigen::Vector3d& place) {
            const auto level = [&](std::uint32_t kind) { // grains of 0.5 mm
                return 0.3 + 0.6 * noiseAt(50 * place, kind);
            };
            return Light(level(0), level(1), level(2));
        });
    }
    if (name == QLatin1String("dark")) {
        return map([](const Eigen::Vector3d& place) {
            return noiseAt(8 * place, 9) > 0.62 ? Light(0.02, 0.015, 0.01) : Light(0.45, 0.3, 0.12);
        });
    }
    return std::nullopt;
}

Project ballWith(const QString& name, const QImage& picture) {
    constexpr int rings = 96, segments = 192;
    auto model = std::make_shared<TexturedMesh>();
    model->mesh = sphereMesh(25, rings, segments);
    for (const auto& corners : model->mesh.triangles) {
        std::array<Eigen::Vector2f, 3> uv;
        std::array<double, 3> around{}, up{};
        for (std::size_t k = 0; k < 3; ++k) {
            const Eigen::Vector3f& place = model->mesh.positions[corners[k]];
            up[k] =
                0.5 + std::asin(std::clamp(double(place.y()) / 25, -1.0, 1.0)) / std::numbers::pi;
            around[k] =
                std::atan2(double(place.z()), double(place.x())) / (2 * std::numbers::pi) + 0.5;
        }
        // A pole takes the longitude of the other corners; the seam is crossed by repeating.
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t a = (k + 1) % 3, b = (k + 2) % 3;
            if (up[k] < 1e-4 || up[k] > 1 - 1e-4) {
                around[k] = std::abs(around[a] - around[b]) > 0.5 ? (around[a] + around[b] + 1) / 2
                                                                  : (around[a] + around[b]) / 2;
            }
        }
        const double most = *std::max_element(around.begin(), around.end());
        for (std::size_t k = 0; k < 3; ++k) {
            uv[k] = {float(around[k] + (most - around[k] > 0.5 ? 1 : 0)), float(up[k])};
        }
        model->textureCoordinates.push_back(uv);
        model->material.push_back(0);
    }
    Material material;
    material.texture = 0;
    model->materials = {material};
    model->textures = {picture};
    model->chart = findCharts(*model);
    Project project;
    project.name = name;
    project.model = model;
    project.film.width = Millimetres(200);
    project.film.height = Millimetres(200);
    project.immersions = {Immersion{}};
    project.immersions[0].name = name;
    return project;
}

void measure(const QString& job, const bench::Arguments& arguments, bool isDetailed,
             QTextStream& out) {
    const std::optional<QImage> picture = builtIn(job);
    Project project = picture ? ballWith(job, *picture) : loadProject(job);
    const int dpi = arguments.number("dpi", 600);
    project.sheet.resolution = DotsPerInch(dpi);
    project.sheet.paper = QStringLiteral("film");
    project.sheet.marks = project.sheet.ruler = project.sheet.jobLine = false;
    project.profiles.printer.reset();
    project.immersions.resize(1); // of two dips, each would give only a share of the ink
    JobOptions options;
    const JobResult result = runJob(project, SolverRegistry(), options, nullptr, {});
    const ImmersionResult& dip = result.immersions.front();
    const ForwardFilm film(dip, *dip.appearance);
    const Picture sheet(
        readSheet(dip.sheet, dpi, arguments.value("reader", "png") == std::string("gs")));
    const std::vector<Sample> all =
        samplesOf(film, sheet, project.ink.limit, arguments.number("samples", 400000));
    const std::vector<Sample> counted =
        those(all, [](const Sample& sample) { return sample.isWithinLimit; });
    double whole = 0;
    for (const Sample& sample : all) {
        whole += sample.area;
    }
    out << project.name
        << QStringLiteral(": film %1 × %2 points\n").arg(film.grid().columns).arg(film.grid().rows);
    printLine(QStringLiteral("  within the ink limit"), counted, whole, out);
    if (!isDetailed) {
        return;
    }
    const std::vector<double> ends{0, 0.8, 0.95, 1.05, 1.5, 2.2, 100};
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
        printLine(QStringLiteral("  J %1 to %2").arg(ends[k]).arg(ends[k + 1]),
                  those(counted,
                        [&](const Sample& sample) {
                            return sample.stretch >= ends[k] && sample.stretch < ends[k + 1];
                        }),
                  whole, out);
    }
    printLine(QStringLiteral("  uneven (triangles by 10 %)"),
              those(counted, [](const Sample& sample) { return sample.unevenness > 1.1; }), whole,
              out);
    if (picture) {
        const std::vector<double> angles{0, 45, 80, 95, 105, 110, 180};
        for (std::size_t k = 0; k + 1 < angles.size(); ++k) {
            printLine(QStringLiteral("  %1° to %2°").arg(angles[k]).arg(angles[k + 1]),
                      those(counted,
                            [&](const Sample& sample) {
                                return sample.angle >= angles[k] && sample.angle < angles[k + 1];
                            }),
                      whole, out);
        }
    }
}

} // namespace

int main(int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    const QGuiApplication app(argc, argv);
    QTextStream out(stdout);
    bench::Arguments arguments(argc, argv);
    const bool isDetailed = arguments.take("detail");
    QImageReader::setAllocationLimit(0);
    for (const std::string& job : arguments.words()) {
        try {
            measure(QString::fromStdString(job), arguments, isDetailed, out);
        } catch (const Error& error) {
            out << QString::fromStdString(job) << ": " << error.message() << '\n';
        }
    }
    return 0;
}
