#include "import/cad/CadReader.h"

#include "base/Error.h"
#include "import/cad/CadFaces.h"
#include "import/cad/CadTriangles.h"

#include <QCoreApplication>

#include <IGESControl_Controller.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPCAFControl_Controller.hxx>
#include <Standard_OutOfMemory.hxx>

#include <new>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::ImportModel)
};

UntrustedModel read(const QString& path, UntrustedFiles& files, const Tessellation& tessellation,
                    const Progress& progress) {
    progress(0, Text::tr("Reading the CAD file"));
    const std::optional<QByteArray> bytes = files.read(path);
    if (!bytes) {
        throwDamagedCad(Text::tr("the file cannot be opened"), path);
    }
    const CadDocument document = cadDocument(*bytes, path);
    progress(0.5, Text::tr("Reading the CAD file"));
    const CadFaces faces = cadFaces(document, path);
    UntrustedModel model;
    if (document.failedEntities > 0) {
        model.warnings.append(
            Text::tr("Entities of the CAD file that cannot be read, so that faces or parts may be "
                     "missing: %1")
                .arg(document.failedEntities));
    }
    CadFacts facts;
    facts.unit = document.unit;
    model.mesh = cadTriangles(faces, tessellation, facts.tessellation, model.warnings, path,
                              progress.part(0.6, 1));
    model.cad = facts;
    return model;
}

} // namespace

void prepareCad() {
    Message::DefaultMessenger()->ChangePrinters().Clear();
    STEPCAFControl_Controller::Init();
    IGESControl_Controller::Init();
    Interface_Static::SetCVal("xstep.cascade.unit", "MM");
    Interface_Static::SetIVal("read.stepcaf.subshapes.name", 1);
}

UntrustedModel readCad(const QString& path, UntrustedFiles& files, const Tessellation& tessellation,
                       const Progress& progress) {
    try {
        return read(path, files, tessellation, progress);
    } catch (const Standard_OutOfMemory&) {
        throw std::bad_alloc();
    } catch (const Standard_Failure& failure) {
        throwDamagedCad(Text::tr("its geometry is invalid (%1)")
                            .arg(QString::fromLatin1(failure.DynamicType()->Name())),
                        path);
    }
}

} // namespace dipwright
