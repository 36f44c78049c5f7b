// Models and textures read on the worker thread: for a new project, or in place of those that a
// document has, as one step to undo.
#pragma once

#include "import/trusted/ImportModel.h"
#include "workbench/document/Document.h"
#include "workbench/jobs/JobRunner.h"
#include "workbench/jobs/Messages.h"

namespace dipwright {

// A new project around a model that was read from `path`.
Project newProject(const ImportedModel& imported, const QString& path,
                   const ImportOptions& options);
// Logs what had to be mended or doubted.
void logImport(const ImportedModel& imported, Messages& messages);
// How long the body is, mm, if it is longer or shorter than what is ever dipped: files often do not
// say in which unit they are.
std::optional<double> doubtfulLength(const TriangleMesh& mesh);

// Reads a model; `done` takes it on the UI thread. Files outside the model's folder are asked for
// first. `failureTitle` stands over what went wrong. Jobs and messages must live until then.
void startImport(const QString& path, const ImportOptions& options, const QString& failureTitle,
                 JobRunner& jobs, Messages& messages,
                 const std::function<void(const ImportedModel&)>& done);

// The document must live as long as `jobs` has this to do.
void reloadModel(Document& document, JobRunner& jobs, Messages& messages); // keeps all settings
void replaceModel(Document& document, const QString& path, JobRunner& jobs, Messages& messages);
void replaceTexture(Document& document, const QString& path, JobRunner& jobs, Messages& messages);

} // namespace dipwright
