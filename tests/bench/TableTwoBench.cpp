// Repeats the paper's accuracy experiment (its Table II) with computed photos:
//   table_two_bench FOLDER [solver=ID]
// Dips a ball of 70 mm, a tetrahedron of 60 mm and the turtle through the chessboard, with known
// errors of film and placement (made() below). Photographs the parts by ray casting (PartPhoto.h)
// and measures them as `inspect part --project` does. Prints a table, and writes the photos with
// their residuals to FOLDER.
#include "PartPhoto.h"
#include "base/Units.h"
#include "inspection/FindPrint.h"
#include "inspection/PartViewFiles.h"
#include "pipeline/Pipeline.h"
#include "project/ProjectStore.h"
#include "project/Samples.h"
#include "texture/Chessboard.h"

#include <QFileInfo>
#include <QGuiApplication>
#include <QTextStream>

#include <Eigen/Geometry>

#include <algorithm>
#include <random>

using namespace dipwright;
using namespace dipwright::test;

namespace {

struct Case {
    QString sample;
    std::size_t points; // the paper's N
    double paperShare;  // R divided by the diagonal, %
    double square;      // mm; with 17 mm, the tetrahedron would show only a few corners
    double aside;       // sideways over downward distance of the cameras from the part; one camera
                        // is on each side
};

// The known errors of film and placement.
constexpr double swellX = 1.015, swellY = 1.01;
constexpr double asideX = 0.8, asideZ = -0.5; // mm
constexpr double turnedBy = 1;                // degrees about the vertical axis

Project made(Project project) {
    project.film.swellX *= swellX;
    project.film.swellY *= swellY;
    for (Immersion& immersion : project.immersions) {
        immersion.offset = {Millimetres(asideX), Millimetres(asideZ)};
        immersion.rotation = rotationAngles(
            Eigen::AngleAxisd(turnedBy * pi / 180, Eigen::Vector3d::UnitY()).toRotationMatrix() *
            rotationMatrix(immersion.rotation));
    }
    return project;
}

std::shared_ptr<const LaidFilm> dipped(const Project& project, const QString& solver) {
    const SolverRegistry registry;
    JobOptions options;
    options.solver = solver;
    options.chessboard = true;
    options.estimatesNumericalError = false;
    return runJob(project, registry, options, nullptr, {}).immersions[0].laid;
}

// Returns a camera that looks from below, where the film was, and from one side.
PhotoCamera cameraOf(const LaidFilm& laid, double aside) {
    const PosedBody& body = laid.body();
    const auto box = boundingBox(body.mesh);
    const double size = double(box.sizes().maxCoeff());
    const Eigen::Vector3d middle = box.center().cast<double>();
    const Eigen::Vector3d from =
        middle + 3.2 * size * Eigen::Vector3d(0.3 * aside, -1, aside).normalized();
    const Eigen::Isometry3d back = body.modelToPose.inverse();
    PhotoCamera camera =
        cameraFrom(back * from, back * middle, back.linear() * Eigen::Vector3d(0, 0.2, 1));
    camera.focalLength = 2.4;
    camera.k1 = -0.06;
    camera.k2 = 0.02;
    return camera;
}

// Adds 24 places of the body's surface. Each is clicked with an error of 1.5 pixels (standard
// deviation).
void clickOnBody(const TriangleMesh& mesh, const PhotoCamera& camera, int photo,
                 std::vector<PlacePair>& pairs) {
    const SurfaceQuery query(mesh);
    const std::size_t count = pairs.size() + 24;
    std::mt19937 random(19 + unsigned(photo));
    std::normal_distribution<double> off(0, 1.5);
    std::uniform_int_distribution<std::size_t> any(0, mesh.triangles.size() - 1);
    std::uniform_real_distribution<float> share(0, 1);
    while (pairs.size() < count) {
        const float u = share(random), v = share(random) * (1 - u);
        const SurfacePoint point{std::uint32_t(any(random)), {1 - u - v, u, v}};
        const Eigen::Vector3d place = position(mesh, point).cast<double>();
        const Eigen::Vector3d sight = place - camera.eye();
        const float depth = query.hit(camera.eye().cast<float>(), sight.cast<float>()).distance;
        if (depth > 0.999f) {
            pairs.push_back(
                {photo, camera.seen(place) + Eigen::Vector2d(off(random), off(random)), place});
        }
    }
}

// Returns `count` places, as many as in the paper, far from each other.
std::vector<PrintedPlace> spreadOut(const std::vector<PrintedPlace>& places, std::size_t count) {
    std::vector<PrintedPlace> chosen{places.front()};
    const auto away = [&](const PrintedPlace& place) {
        double nearest = 1e9;
        for (const PrintedPlace& other : chosen) {
            const double photo =
                other.photo == place.photo ? 0 : 5; // mm; places in another photo count as farther
            nearest = std::min(nearest, (other.model - place.model).norm() + photo);
        }
        return nearest;
    };
    while (chosen.size() < std::min(count, places.size())) {
        chosen.push_back(*std::max_element(
            places.begin(), places.end(),
            [&](const PrintedPlace& a, const PrintedPlace& b) { return away(a) < away(b); }));
    }
    return chosen;
}

// Returns the mean distance, in pixels, between the intended and the true places of the film.
double trueMean(const std::vector<PrintedPlace>& places, const std::vector<PrintedCorner>& truth,
                const std::vector<PhotoCamera>& cameras) {
    double sum = 0;
    int count = 0;
    for (const PrintedPlace& place : places) {
        const PhotoCamera& camera = cameras[std::size_t(place.photo)];
        for (const PrintedCorner& corner : truth) {
            if (corner.sheet == place.sheet) {
                sum += (camera.seen(corner.model) - camera.seen(place.model)).norm();
                ++count;
            }
        }
    }
    return sum / std::max(1, count);
}

QString figuresLine(const PartFigures& figures) {
    return QStringLiteral("%1 | %2 ± %3 | %4 %")
        .arg(figures.count)
        .arg(figures.meanPixels, 0, 'f', 2)
        .arg(figures.deviationPixels, 0, 'f', 2)
        .arg(100 * figures.shareOfDiagonal, 0, 'f', 2);
}

void measure(const Case& one, const QString& folder, const QString& solver, QTextStream& out) {
    QString path;
    for (const QString& file : sampleProjects()) {
        path = QFileInfo(file).completeBaseName() == one.sample ? file : path;
    }
    Project project = loadProject(path);
    project.immersions.resize(1);
    // For docs/inspection.md: an A4 film of 120 × 170 points, and the whole body is dipped.
    project.film = {};
    project.process.depth.reset();
    if (one.sample == QLatin1String("tetrahedron")) {
        project.immersions[0].rotation = {Degrees(180), Degrees(0), Degrees(0)}; // point first
    }
    project.sheet.resolution = DotsPerInch(72);
    const QSizeF sheet(project.film.width.value(), project.film.height.value());
    const auto meant = dipped(project, solver), done = dipped(made(project), solver);
    const auto corners = chessboardCorners(*meant, 0, sheet, one.square);
    const auto truth = chessboardCorners(*done, 0, sheet, one.square);
    const std::vector<PhotoCamera> cameras{cameraOf(*meant, one.aside),
                                           cameraOf(*meant, -one.aside)};
    const TriangleMesh& mesh = project.model->mesh;
    std::vector<PlacePair> clicked;
    std::vector<PartPhoto> photos;
    std::vector<QImage> pictures;
    for (const PhotoCamera& camera : cameras) {
        clickOnBody(mesh, camera, int(photos.size()), clicked);
        pictures.push_back(partPhoto(mesh, chessboardPrint(*done, sheet, one.square), camera, {}));
        photos.push_back({one.sample, {}, pictures.back()});
    }
    for (const bool keepsCamera : {true, false}) {
        const FoundPrint print =
            findPrint(pictures, mesh, corners, clicked, {keepsCamera, {}}, {}, path);
        const auto chosen = spreadOut(print.places, one.points);
        const PartView view = viewOf(print.view, pairsOf(chosen), pictures.front().size());
        out << QStringLiteral("| %1, %2 | %3 | %4 px | %5 of %6 | %7 mm | %8 mm | %9 % |\n")
                   .arg(one.sample,
                        keepsCamera ? QStringLiteral("by the body")
                                    : QStringLiteral("by the print"),
                        figuresLine(view.figures))
                   .arg(trueMean(chosen, truth, cameras), 0, 'f', 2)
                   .arg(print.places.size())
                   .arg(print.expected[0] + print.expected[1])
                   .arg(view.figures.percentile95, 0, 'f', 2)
                   .arg(view.figures.worst, 0, 'f', 2)
                   .arg(one.paperShare, 0, 'f', 2);
        out.flush();
        if (keepsCamera) {
            writePartView(photos, pairsOf(print.places), print.view, print.places,
                          folder + QStringLiteral("/") + one.sample);
        }
    }
}

} // namespace

int main(int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    const QGuiApplication app(argc, argv);
    QTextStream out(stdout);
    const QStringList arguments = QCoreApplication::arguments().mid(1);
    if (arguments.isEmpty()) {
        out << "table_two_bench FOLDER [solver=ID]\n";
        return 2;
    }
    const QString solver = arguments.value(1).section(QLatin1Char('='), 1);
    out << "| part, camera | N | R ± σ, px | R / diagonal | true R | found | p95 | worst | paper "
           "|\n"
           "| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n";
    for (const Case& one : {Case{QStringLiteral("sphere"), 16, 0.78, chessSquare, 0.5},
                            Case{QStringLiteral("tetrahedron"), 14, 0.56, 10, 0.3},
                            Case{QStringLiteral("turtle"), 13, 0.57, chessSquare, 0.3}}) {
        measure(one, arguments.first(), solver, out);
    }
    return 0;
}
