// Reads models and textures on the worker thread: for a new project, or to replace the model or
// texture of a document as one undo step.
#pragma once

#include "import/trusted/ImportModel.h"
#include "workbench/document/Document.h"
#include "workbench/jobs/JobRunner.h"
#include "workbench/jobs/Messages.h"

namespace dipwright {

// Returns a new project with a model that was read from `path`.
Project newProject(const ImportedModel& imported, const QString& path,
                   const ImportOptions& options);
// Logs repairs and warnings, and shows the warnings.
void logImport(const ImportedModel& imported, Messages& messages);
// Returns the length of the body in mm if it is implausible, else nullopt. Many files do not state
// their unit, so the import may have used the wrong one.
std::optional<double> implausibleLength(const TriangleMesh& mesh);

// Reads a model and calls `done` on the UI thread. Asks before it reads files outside the model's
// folder. `failureTitle` is the title of an error message. `jobs` and `messages` must outlive the
// job.
void startImport(const QString& path, const ImportOptions& options, const QString& failureTitle,
                 JobRunner& jobs, Messages& messages,
                 const std::function<void(const ImportedModel&)>& done);

// Reads the model's file again and keeps all settings. The document must outlive the job.
void reloadModel(Document& document, JobRunner& jobs, Messages& messages);
// Makes the triangles of a CAD model again with another tolerance, which is one undo step. The
// document must outlive the job.
void retessellate(Document& document, Millimetres tolerance, JobRunner& jobs, Messages& messages);
// Replaces the model. The document must outlive the job.
void replaceModel(Document& document, const QString& path, JobRunner& jobs, Messages& messages);
// Replaces the texture. The document must outlive the job.
void replaceTexture(Document& document, const QString& path, JobRunner& jobs, Messages& messages);

} // namespace dipwright
