#include "import/trusted/ImportModel.h"

#include "base/Budgets.h"
#include "base/NumberText.h"
#include "base/ProcessorTime.h"
#include "geometry/Solid.h"
#include "import/trusted/ModelFolder.h"
#include "import/trusted/OverlappingFaces.h"
#include "import/trusted/ReadPictures.h"
#include "import/trusted/ReaderProcess.h"
#include "model/MeshRepair.h"
#include "model/ModelFormats.h"
#include "model/TextureNotes.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>

#include <algorithm>
#include <cmath>

namespace dipwright {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::ImportModel)
};

// Largest allowed edge of a model, mm; far larger than any dip tank.
constexpr double maximumEdge = 1e5;
// Largest allowed texture coordinate. Beyond it, a float cannot resolve a place in a picture.
constexpr float maximumTextureCoordinate = 1e5F;

void checkOptions(const ImportOptions& options) {
    const double edge = options.longestEdge.value_or(Millimetres(1)).value();
    if (!(edge > 0) || edge > maximumEdge) {
        throw Error(
            Text::tr("The model's size must be more than 0 and at most %1 mm").arg(maximumEdge),
            QString::number(edge));
    }
    if (!(options.unitMillimetres > 0) || !std::isfinite(options.unitMillimetres)) {
        throw Error(Text::tr("The model's unit must be a positive number of millimetres"),
                    QString::number(options.unitMillimetres));
    }
}

void checkFile(const QString& path) {
    const QFileInfo file(path);
    if (!file.exists()) {
        throw Error(Text::tr("The model file does not exist; check its name"), path);
    }
    if (file.isDir()) {
        throw Error(Text::tr("This is a folder; choose a model file in it"), path);
    }
    if (!file.isReadable()) {
        throw Error(Text::tr("The model file cannot be read; check its permissions"), path);
    }
    if (file.size() == 0) {
        throw Error(Text::tr("The model file is empty; save it again"), path);
    }
}

// Returns the picture at a path; a null image if the path is empty.
ReadPicture replacementTexture(const QString& path) {
    return path.isEmpty() ? ReadPicture() : readPictureAndInks(path);
}

void checkPositions(const TriangleMesh& mesh, const QString& path) {
    std::size_t bad = 0;
    for (const auto& triangle : mesh.triangles) {
        for (const auto corner : triangle) {
            bad += !mesh.positions[corner].allFinite();
        }
    }
    if (bad > 0) {
        throw Error(
            Text::tr("%1 corners of the model's triangles are not numbers (NaN or infinite); "
                     "repair the model and save it again")
                .arg(bad),
            path);
    }
}

// Returns a function to call during repairs, on the thread that repairs. The function throws if the
// repairs are cancelled, or if they need more processor time than reading `fileBytes` bytes.
std::function<void()> repairCheckpoint(const QString& path, qint64 fileBytes,
                                       const Progress& progress) {
    const auto end = threadProcessorTime() +
                     std::chrono::milliseconds(budgetLimit(Budget::Milliseconds, fileBytes));
    return [=, cancelToken = progress.cancelToken] {
        cancelToken.throwIfCancelled();
        if (threadProcessorTime() > end) {
            throw Error(sentenceOf(Budget::Milliseconds, fileBytes), path);
        }
    };
}

double median(std::vector<double> numbers) {
    const auto middle = numbers.begin() + std::ssize(numbers) / 2;
    std::nth_element(numbers.begin(), middle, numbers.end());
    return *middle;
}

// Returns the distance of each position from the middle of most positions.
std::vector<double> distancesFromMiddle(const TriangleMesh& mesh) {
    Eigen::Vector3d middle;
    std::vector<double> numbers(mesh.positions.size());
    for (int axis = 0; axis < 3; ++axis) {
        std::transform(mesh.positions.begin(), mesh.positions.end(), numbers.begin(),
                       [&](const Eigen::Vector3f& point) { return double(point[axis]); });
        middle[axis] = median(numbers);
    }
    std::transform(
        mesh.positions.begin(), mesh.positions.end(), numbers.begin(),
        [&](const Eigen::Vector3f& point) { return (point.cast<double>() - middle).norm(); });
    return numbers;
}

// Throws if a few points lie absurdly far from the others, or most lie absurdly far apart. Repairs
// compare distances with the longest edge of the bounding box, so such points would let them merge
// the rest of the model. `mesh` must be welded.
void requireSoundSize(const TriangleMesh& mesh, const QString& path) {
    constexpr double farthest = 1e4; // times the distance of most points from their middle
    constexpr double largest = 1e12; // in the file's unit; in floats, squares must not overflow
    if (mesh.positions.empty()) {
        return;
    }
    const std::vector<double> distances = distancesFromMiddle(mesh);
    const double usual = median(distances);
    if (usual > largest) {
        throw Error(Text::tr("The model's coordinates are too large; scale the model down in a "
                             "modelling program and save it again"),
                    path);
    }
    const auto stray = std::count_if(distances.begin(), distances.end(),
                                     [&](double distance) { return distance > farthest * usual; });
    if (stray > 0) {
        throw Error(
            Text::tr("Some points of the model (%1) lie more than %2 times as far from its "
                     "middle as most points; delete them in a modelling program and save the "
                     "model again")
                .arg(stray)
                .arg(farthest),
            path);
    }
}

ModelRepairs repair(TexturedMesh& model, const QString& path,
                    const std::function<void()>& checkpoint) {
    ModelRepairs repairs;
    weldPositions(model.mesh);
    checkpoint();
    repairs.removedTriangles = int(removeCollapsedTriangles(model));
    requireSoundSize(model.mesh, path);
    repairs.joinedPoints = int(joinOpenSeams(model.mesh));
    checkpoint();
    repairs.removedTriangles += int(removeDegenerateTriangles(model));
    // A closed mesh keeps triangles without area, and all its triangles may be such.
    if (surfaceArea(model.mesh) == 0) {
        throw Error(Text::tr("None of the model's triangles has an area; choose another model"),
                    path);
    }
    checkpoint();
    repairs.mergedTriangles = int(mergeDoubledTriangles(model));
    repairs.turnedTriangles = int(orientTriangles(model));
    repairs.turnedParts = int(flipInsideOutParts(model, checkpoint));
    repairs.enclosedTriangles = int(removeEnclosedParts(model, checkpoint));
    if (repairs.removedTriangles + repairs.mergedTriangles + repairs.enclosedTriangles > 0) {
        weldPositions(model.mesh); // drops the points of removed triangles
    }
    return repairs;
}

[[noreturn]] void throwTooFar(const QString& path) {
    throw Error(
        Text::tr("The model lies too far from its origin; move it to the origin and save it again"),
        path);
}

// Throws if the mesh is too far from its origin. Floats have seven digits. Farther away than
// `farthest`, rounding would distort the body by more than 1/2000 of its size.
void requireNearOrigin(const TriangleMesh& mesh, double longestEdge, const QString& path) {
    constexpr double farthest = 1e4; // longest edges
    const Eigen::AlignedBox3f box = boundingBox(mesh);
    if (box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).maxCoeff() > farthest * longestEdge) {
        throwTooFar(path);
    }
}

// Returns the factor by which it scales.
double scaleAsAsked(TriangleMesh& mesh, const ImportOptions& options, const QString& path) {
    const double edge = longestEdgeOf(mesh);
    if (edge == 0) {
        throw Error(Text::tr("All points of the model coincide; choose another model"), path);
    }
    requireNearOrigin(mesh, edge, path);
    const double factor =
        options.longestEdge ? options.longestEdge->value() / edge : options.unitMillimetres;
    if (edge * factor > maximumEdge) {
        throw Error(
            Text::tr(
                "The model's largest dimension would be %1 mm; set the size that it should have")
                .arg(edge * factor),
            path);
    }
    scale(mesh, factor);
    if (!boundingBox(mesh).sizes().allFinite()) {
        throwTooFar(path);
    }
    return factor;
}

void describe(const TexturedMesh& model, ImportReport& report) {
    report.triangles = model.mesh.triangles.size();
    report.closed = boundsSolid(model.mesh);
    report.volume = volume(model.mesh);
    report.box = boundingBox(model.mesh);
    if (!report.closed) {
        report.warnings.push_back(
            Text::tr("The mesh is not closed, so the program can only estimate which points lie "
                     "inside it; if the result looks wrong, close the mesh"));
    }
    if (const double area = overlappingArea(model); area > 0) {
        report.warnings.push_back(
            Text::tr("Faces of different colours or textures overlap in one plane, on about %1 "
                     "mm², and either may be printed there; in a modelling program, delete the "
                     "faces that should not show, or move one body by 0.1 mm")
                .arg(roundedText(area, 2)));
    }
    if (const float edge = report.box.sizes().maxCoeff(); edge < 1) {
        report.warnings.push_back(
            Text::tr("The model's largest dimension is only %1 mm; if its file is not in "
                     "millimetres, set the size that it should have")
                .arg(double(edge)));
    }
}

bool hasAnyTextureCoordinates(const TexturedMesh& model) {
    for (std::size_t t = 0; t < model.mesh.triangles.size(); ++t) {
        if (model.hasTextureCoordinates(t)) {
            return true;
        }
    }
    return false;
}

void dropUselessTextures(TexturedMesh& model, QStringList& warnings) {
    if (model.textures.empty() || hasAnyTextureCoordinates(model)) {
        return;
    }
    warnings.push_back(Text::tr("The model has no texture coordinates, so its texture cannot be "
                                "placed; the colours of its materials are used instead"));
    model.textures.clear();
    model.inks.clear();
    for (Material& material : model.materials) {
        material.texture = -1;
    }
}

void dropUnusableCoordinates(TexturedMesh& model, QStringList& warnings) {
    const auto isMissing = [](const Eigen::Vector2f& uv) { return uv.array().isNaN().all(); };
    const auto isUsable = [](const Eigen::Vector2f& uv) { // false for NaN
        return (uv.array().abs() <= maximumTextureCoordinate).all();
    };
    std::size_t dropped = 0;
    for (auto& corners : model.textureCoordinates) {
        if (!std::all_of(corners.begin(), corners.end(), isMissing) &&
            !std::all_of(corners.begin(), corners.end(), isUsable)) {
            ++dropped;
            corners.fill(Eigen::Vector2f::Constant(std::nanf("")));
        }
    }
    if (dropped > 0) {
        warnings.push_back(
            Text::tr("The texture coordinates of %1 triangles are not numbers or are too large; "
                     "these triangles show their material's colour")
                .arg(dropped));
    }
}

void replaceTextures(TexturedMesh& model, const ReadPicture& texture) {
    model.textures = {texture.colours};
    model.inks = texture.inks.isNull() ? std::vector<QImage>() : std::vector{texture.inks};
    for (Material& material : model.materials) {
        material.texture = 0;
    }
}

// Reads a model file. Reports files outside the folder first, whatever other errors their absence
// caused.
UntrustedModel readModelFile(const QString& path, ModelFolder& folder, bool withTextures,
                             const Progress& progress) {
    const auto checkOutside = [&] {
        if (!folder.outside().isEmpty()) {
            throw OutsideFiles(folder.outside(), path);
        }
    };
    try {
        UntrustedModel model = readModelInProcess(path, withTextures, folder, progress);
        checkOutside();
        return model;
    } catch (const Error&) {
        checkOutside();
        throw;
    }
}

// Repairs, scales and describes a model as it was read. `fileBytes` limits the time for this.
ImportedModel finished(UntrustedModel foreign, const ReadPicture& texture, const QString& path,
                       const ImportOptions& options, qint64 fileBytes, const Progress& progress) {
    ImportedModel result;
    TexturedMesh& model = result.model;
    ImportReport& report = result.report;
    model = std::move(foreign.mesh);
    report.losses = foreign.warnings;
    report.cad = foreign.cad;
    if (model.mesh.triangles.empty()) {
        throw Error(Text::tr("The model has no triangles; save it with its surface"), path);
    }
    if (!texture.colours.isNull()) {
        replaceTextures(model, texture);
    }
    progress(0, Text::tr("Checking the model"));
    checkPositions(model.mesh, path);
    dropUnusableCoordinates(model, report.losses);
    report.repaired = repair(model, path, repairCheckpoint(path, fileBytes, progress));
    report.repairs = sentencesOf(report.repaired);
    report.unitMillimetres = scaleAsAsked(model.mesh, options, path);
    dropUselessTextures(model, report.losses);
    report.warnings = report.losses + colourNotes(model);
    progress(0.66, Text::tr("Finding the texture's charts"));
    model.chart = findCharts(model);
    describe(model, report);
    progress(1, Text::tr("Checking the model"));
    return result;
}

// The one file of a CAD model.
class OneFile : public UntrustedFiles {
public:
    explicit OneFile(const QByteArray& content) : content_(content) {}

private:
    std::optional<QByteArray> fetch(const QString&) override { return content_; }

    QByteArray content_;
};

ImportedModel cadModel(const QString& path, const QByteArray& content, const ReadPicture& texture,
                       const ImportOptions& options, const Progress& progress) {
    OneFile file(content);
    Tessellation tessellation;
    tessellation.tolerance = options.tessellation.value();
    tessellation.unitMillimetres = options.unitMillimetres;
    tessellation.longestEdge = options.longestEdge ? options.longestEdge->value() : 0;
    UntrustedModel foreign = readCadInProcess(path, tessellation, file, progress.part(0, 0.7));
    // CAD files describe much in few bytes, so the time for repairs counts the triangles' bytes.
    constexpr qint64 bytesOfTriangle = 50; // as in a binary STL file
    const qint64 bytes = bytesOfTriangle * qint64(foreign.mesh.mesh.triangles.size());
    ImportedModel result =
        finished(std::move(foreign), texture, path, options, bytes, progress.part(0.7, 1));
    result.cadFile = content;
    return result;
}

ImportedModel import(const QString& path, const ImportOptions& options, const Progress& progress) {
    checkOptions(options);
    checkFile(path);
    const ReadPicture texture = replacementTexture(options.texture);
    if (isCadFile(path)) {
        const std::optional<QByteArray> content = readFile(path);
        if (!content) {
            throw Error(Text::tr("The model file cannot be read; check its permissions"), path);
        }
        return cadModel(path, *content, texture, options, progress);
    }
    ModelFolder folder(path, options.allowOutside, options.outsideFiles);
    UntrustedModel foreign =
        readModelFile(path, folder, texture.colours.isNull(), progress.part(0, 0.7));
    return finished(std::move(foreign), texture, path, options, folder.bytesRead(),
                    progress.part(0.7, 1));
}

template <typename Import>
ImportedModel withinMemory(const QString& path, const Import& import) {
    try {
        return import();
    } catch (const std::bad_alloc&) {
        throw Error(
            Text::tr("The model needs more memory than this computer has; simplify the model"),
            path);
    }
}

} // namespace

double guessedUnit(double longestEdge) {
    constexpr double smallest = 10, largest = 1000; // sizes of typical parts, mm
    for (const double unit : {1.0, 10.0, 1000.0, millimetresPerInch}) {
        if (longestEdge * unit >= smallest && longestEdge * unit <= largest) {
            return unit;
        }
    }
    return 1;
}

OutsideFiles::OutsideFiles(const QStringList& files, const QString& model)
    : Error(Text::tr("The model was not read, because it names files that are hidden or outside "
                     "its folder, such as %1; put these files beside the model, or allow them "
                     "(--allow-outside)")
                .arg(QDir::toNativeSeparators(files.first())),
            model),
      files_(files) {}

TexturedMesh withTexture(const TexturedMesh& model, const QString& path) {
    if (!hasAnyTextureCoordinates(model)) {
        throw Error(Text::tr("The model has no texture coordinates, so no picture can be placed on "
                             "it; unwrap it in a modelling program first"),
                    path);
    }
    TexturedMesh other = model;
    replaceTextures(other, replacementTexture(path));
    return other;
}

ImportedModel importModel(const QString& path, const ImportOptions& options,
                          const Progress& progress) {
    return withinMemory(path, [&] { return import(path, options, progress); });
}

ImportedModel importCad(const QString& name, const QByteArray& content,
                        const ImportOptions& options, const Progress& progress) {
    return withinMemory(name, [&] {
        checkOptions(options);
        return cadModel(name, content, {}, options, progress);
    });
}

} // namespace dipwright
