#include "cli/Arguments.h"
#include "dip/BodyPath.h"
#include "geometry/FieldGrid.h"
#include "geometry/Solid.h"
#include "marks/SurfaceMask.h"
#include "model/NamedMaterials.h"
#include "model/TextureNotes.h"
#include "model/TexturedMesh.h"
#include "project/CadModel.h"
#include "project/Project.h"
#include "settings/FilmSettings.h"
#include "settings/Immersion.h"

#include <Eigen/Core>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <cmath>

namespace dipwright::cli {
namespace {

const QString jsonOption = QStringLiteral("json");

QString plain(double number) {
    return QString::number(number, 'g', 6);
}

QJsonObject modelJson(const TexturedMesh& model) {
    const Eigen::Vector3f size = boundingBox(model.mesh).sizes();
    QJsonArray textures;
    for (const QImage& texture : model.textures) {
        textures.append(QJsonArray{texture.width(), texture.height()});
    }
    return {{"triangles", qint64(model.mesh.triangles.size())},
            {"positions", qint64(model.mesh.positions.size())},
            {"size_mm", QJsonArray{size.x(), size.y(), size.z()}},
            {"area_mm2", surfaceArea(model.mesh)},
            {"volume_mm3", volume(model.mesh)},
            {"closed", boundsSolid(model.mesh)},
            {"materials", qint64(model.materials.size())},
            {"material_names", QJsonArray::fromStringList(materialNames(model))},
            {"textures", textures}};
}

void printModel(const TexturedMesh& model, const QString& notes, QTextStream& out) {
    const Eigen::Vector3f size = boundingBox(model.mesh).sizes();
    out << QStringLiteral("Model: %1 triangles, %2 × %3 × %4 mm, %5 cm³, %6\n")
               .arg(model.mesh.triangles.size())
               .arg(plain(size.x()), plain(size.y()), plain(size.z()),
                    plain(volume(model.mesh) / 1000),
                    boundsSolid(model.mesh) ? QStringLiteral("closed")
                                            : QStringLiteral("not closed"));
    if (!notes.isEmpty()) {
        out << QStringLiteral("Notes from the import: %1\n").arg(notes);
    }
    for (const QImage& texture : model.textures) {
        out << QStringLiteral("Texture: %1 × %2 pixels\n")
                   .arg(texture.width())
                   .arg(texture.height());
    }
    for (const QString& note : colourNotes(model)) {
        out << QStringLiteral("Note: %1\n").arg(note);
    }
}

QString pointsText(const FilmSettings& film) {
    switch (film.resolution) {
    case FilmResolution::Automatic:
        return QStringLiteral("cells as fine as each pose needs");
    case FilmResolution::Cell:
        return QStringLiteral("cells of %1 mm over the part").arg(plain(film.cell.value()));
    case FilmResolution::Points:
        break;
    }
    return QStringLiteral("%1 × %2 points").arg(film.columns).arg(film.rows);
}

void printFilm(const FilmSettings& film, QTextStream& out) {
    const double relaxation = film.relaxationTime.value();
    out << QStringLiteral("Film: %1, %2 × %3 mm, %4, swell %5 × %6, %7\n")
               .arg(film.preset, plain(film.width.value()), plain(film.height.value()),
                    pointsText(film), plain(film.swellX), plain(film.swellY),
                    std::isinf(relaxation) ? QStringLiteral("elastic")
                    : relaxation == 0      ? QStringLiteral("viscous")
                                           : QStringLiteral("relaxing in %1 s").arg(relaxation));
}

void printImmersion(const Immersion& immersion, QTextStream& out) {
    out << QStringLiteral(
               "Dip %1: rotated by %2°, %3°, %4° about X, Y, Z; offset x %5 mm, z %6 mm\n")
               .arg(immersion.name, plain(immersion.rotation[0].value()),
                    plain(immersion.rotation[1].value()), plain(immersion.rotation[2].value()),
                    plain(immersion.offset[0].value()), plain(immersion.offset[1].value()));
    if (const QString path = pathText(immersion.path); !path.isEmpty()) {
        out << QStringLiteral("  path: %1\n").arg(path);
    }
}

void printProject(const Project& project, QTextStream& out) {
    out << QStringLiteral("Project: %1, created on %2\n").arg(project.name, project.date);
    printModel(*project.model, project.modelOrigin.notes(), out);
    if (const QString cad = cadText(project); !cad.isEmpty()) {
        out << cad << '\n';
        out << QStringLiteral("Faces: %1\n")
                   .arg(materialNames(*project.model).join(QStringLiteral(", ")));
    }
    printFilm(project.film, out);
    const TriangleMesh mesh = inBodyCoordinates(project.model->mesh);
    const FieldGrid field =
        fieldGrid(mesh, project.fieldResolution, thinParts(mesh, SurfaceQuery(mesh)).thickness);
    out << QStringLiteral("Process: %1 mm/s, solver %2, signed distance field of %3 × %4 × %5 "
                          "samples with a spacing of %6 mm\n")
               .arg(plain(project.process.dipSpeed.value()), project.process.solver)
               .arg(field.size[0])
               .arg(field.size[1])
               .arg(field.size[2])
               .arg(plain(field.spacing));
    for (const Immersion& immersion : project.immersions) {
        printImmersion(immersion, out);
    }
    if (const auto mask = surfaceMask(project.model, project.masks)) {
        out << maskText(maskedAreas(*mask)) << '\n';
    }
    out << QStringLiteral("Sheet: %1 dpi on %2\n")
               .arg(plain(project.sheet.resolution.value()), project.sheet.paper);
}

class InfoCommand : public Command {
public:
    QString name() const override { return QStringLiteral("info"); }
    QString summary() const override { return QStringLiteral("Shows what a project contains."); }
    void declare(CommandSyntax& syntax) const override {
        declareProject(syntax);
        syntax.addOption(
            {jsonOption, QStringLiteral("Prints JSON: the project file's document and, as "
                                        "\"model_info\", the model's figures.")});
    }
    void run(const QCommandLineParser& parser, Console& console) const override {
        const Project project = projectArgument(parser);
        if (!parser.isSet(jsonOption)) {
            printProject(project, console.out());
            return;
        }
        QJsonObject json = toJson(project);
        json.insert(QStringLiteral("model_info"), modelJson(*project.model));
        if (const auto mask = surfaceMask(project.model, project.masks)) {
            const MaskedAreas masked = maskedAreas(*mask);
            json.insert(QStringLiteral("mask_info"),
                        QJsonObject{{"areas", qint64(masked.count)}, {"area_mm2", masked.area}});
        }
        console.out() << QJsonDocument(json).toJson();
    }
};

} // namespace

std::unique_ptr<Command> infoCommand() {
    return std::make_unique<InfoCommand>();
}

} // namespace dipwright::cli
