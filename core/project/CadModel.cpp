#include "project/CadModel.h"

#include "base/Error.h"
#include "base/NumberText.h"
#include "import/trusted/ImportModel.h"
#include "project/Project.h"
#include "settings/SurfaceMark.h"

#include <QCoreApplication>
#include <QFileInfo>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::CadModel)
};

} // namespace

void takeModel(Project& project, ImportedModel imported, const QString& path) {
    ModelOrigin& origin = project.modelOrigin;
    origin.source = path;
    origin.remarks = imported.report.remarks();
    origin.losses = imported.report.losses.join(QStringLiteral("; "));
    origin.sha256.clear();
    origin.tessellation = Millimetres(0);
    origin.fileUnit.clear();
    project.cad = {};
    if (const std::optional<CadFacts>& cad = imported.report.cad) {
        origin.tessellation = Millimetres(cad->tessellation);
        origin.fileUnit = cad->unit;
        origin.unitMillimetres = imported.report.unitMillimetres;
        project.cad = {QFileInfo(path).fileName().right(longestMaterialName), imported.cadFile};
    }
    project.model = std::make_shared<const TexturedMesh>(std::move(imported.model));
}

QString cadText(const Project& project) {
    if (project.cad.name.isEmpty()) {
        return {};
    }
    const ModelOrigin& origin = project.modelOrigin;
    return Text::tr("CAD file %1 in %2, faces: %3, tolerance of the triangles: %4 mm")
        .arg(project.cad.name,
             origin.fileUnit.isEmpty() ? Text::tr("mm (its unit is unknown)") : origin.fileUnit)
        .arg(project.model->materials.size())
        .arg(roundedText(origin.tessellation.value(), 3));
}

void requireCad(bool isCad, const QString& where) {
    if (!isCad) {
        throw Error(Text::tr("Only a model from a CAD file (STEP, IGES) can be cut into other "
                             "triangles; import such a file"),
                    where);
    }
}

ImportedModel retessellated(const Project& project, Millimetres tolerance,
                            const Progress& progress) {
    requireCad(!project.cad.bytes.isEmpty(), project.name);
    ImportOptions options;
    options.unitMillimetres = project.modelOrigin.unitMillimetres;
    options.tessellation = tolerance;
    return importCad(project.cad.name, project.cad.bytes, options, progress);
}

} // namespace dipwright
