#include "workbench/document/ModelImport.h"

#include "model/ModelFormats.h"
#include "project/CadModel.h"
#include "project/NewProject.h"
#include "workbench/jobs/StartJob.h"

#include <QCoreApplication>

namespace dipwright {

namespace {

enum class Pose { Kept, Reset };

// Pose::Kept also keeps the size of the present model, because the settings were made for it.
void importInto(Document& document, const QString& path, const QString& texture, Pose pose,
                const QString& undoText, JobRunner& jobs, Messages& messages) {
    ImportOptions options;
    options.texture = texture;
    options.unitMillimetres = namesUnit(path) ? 1 : document.project().modelOrigin.unitMillimetres;
    if (pose == Pose::Kept) {
        options.tessellation = document.project().modelOrigin.tessellation;
        options.longestEdge = Millimetres(longestEdgeOf(document.project().model->mesh));
    }
    startImport(
        path, options, undoText, jobs, messages,
        [&document, &messages, path, options, pose, undoText](const ImportedModel& imported) {
            logImport(imported, messages);
            document.edit(undoText, {}, [&](Project& project) {
                setModel(project, imported, path, options);
                for (Immersion& immersion : project.immersions) {
                    immersion = pose == Pose::Kept ? immersion : Immersion{.name = immersion.name};
                }
            });
        });
}

} // namespace

Project newProject(const ImportedModel& imported, const QString& path,
                   const ImportOptions& options) {
    Project project = newProject(path);
    project.immersions.front().name = QCoreApplication::translate("ModelImport", "Dip %1").arg(1);
    setModel(project, imported, path, options);
    return project;
}

void logImport(const ImportedModel& imported, Messages& messages) {
    for (const QString& line : imported.report.repairs + imported.report.warnings) {
        messages.log(line);
    }
    messages.notice(imported.report.warnings.join(u'\n'));
}

std::optional<double> implausibleLength(const TriangleMesh& mesh) {
    constexpr double smallest = 5, largest = 3000; // mm, usual parts
    const double longest = longestEdgeOf(mesh);
    return longest < smallest || longest > largest ? std::optional(longest) : std::nullopt;
}

void startImport(const QString& path, const ImportOptions& options, const QString& failureTitle,
                 JobRunner& jobs, Messages& messages,
                 const std::function<void(const ImportedModel&)>& done) {
    const auto failed = [=, &jobs, &messages](const std::exception_ptr& failure) {
        try {
            std::rethrow_exception(failure);
        } catch (const OutsideFiles& outside) {
            ImportOptions again = options;
            again.outsideFiles += outside.files();
            messages.askToRead(failureTitle,
                               QCoreApplication::translate(
                                   "ModelImport", "The model refers to files outside its folder:"),
                               outside.files(), [=, &jobs, &messages] {
                                   startImport(path, again, failureTitle, jobs, messages, done);
                               });
        } catch (...) {
            messages.fail(failureTitle, failure);
        }
    };
    jobs.start(std::make_unique<ValueJob<ImportedModel>>(
        QCoreApplication::translate("ModelImport", "Reading the model"),
        [path, options](const Progress& progress) { return importModel(path, options, progress); },
        done, failed));
}

void reloadModel(Document& document, JobRunner& jobs, Messages& messages) {
    const QString title = QCoreApplication::translate("ModelImport", "Reload model");
    const ModelOrigin& origin = document.project().modelOrigin;
    QStringList untrusted;
    for (const QString& file : {origin.source, origin.texture}) {
        if (!file.isEmpty() && !document.isTrusted(file)) {
            untrusted << file;
        }
    }
    const auto reload = [=, &document, &jobs, &messages, origin = origin] {
        for (const QString& file : untrusted) {
            document.trust(file);
        }
        importInto(document, origin.source, origin.texture, Pose::Kept, title, jobs, messages);
    };
    if (untrusted.isEmpty()) {
        reload();
    } else {
        messages.askToRead(
            title,
            QCoreApplication::translate("ModelImport", "The project file refers to these files:"),
            untrusted, reload);
    }
}

void retessellate(Document& document, Millimetres tolerance, JobRunner& jobs, Messages& messages) {
    const QString undoText = QCoreApplication::translate("ModelImport", "Change tolerance");
    startJob(
        jobs, messages, QCoreApplication::translate("ModelImport", "Making the triangles again"),
        undoText,
        [project = document.project(), tolerance](const Progress& progress) {
            return retessellated(project, tolerance, progress);
        },
        [&document, &messages, undoText](const ImportedModel& imported) {
            logImport(imported, messages);
            document.edit(undoText, {}, [&](Project& project) {
                const CadFile cad = project.cad;
                takeModel(project, imported, project.modelOrigin.source);
                project.cad = cad;
            });
        });
}

void replaceModel(Document& document, const QString& path, JobRunner& jobs, Messages& messages) {
    importInto(document, path, {}, Pose::Reset,
               QCoreApplication::translate("ModelImport", "Replace model"), jobs, messages);
}

void replaceTexture(Document& document, const QString& path, JobRunner& jobs, Messages& messages) {
    const QString undoText = QCoreApplication::translate("ModelImport", "Replace texture");
    startJob(
        jobs, messages, QCoreApplication::translate("ModelImport", "Reading the texture"), undoText,
        [model = document.project().model, path](const Progress&) {
            return withTexture(*model, path);
        },
        [&document, path, undoText](const TexturedMesh& model) {
            document.edit(undoText, {}, [&](Project& project) {
                project.model = std::make_shared<const TexturedMesh>(model);
                project.modelOrigin.texture = path;
                project.modelOrigin.sha256.clear();
            });
        });
}

} // namespace dipwright
