// Makes the outputs of a set (project/OutputSets.h) in a folder, with the writers of the other
// commands. The folder's outputs.json records which files were made, and from which state of the
// project, so that other files are not overwritten and outdated files are recognised.
#pragma once

#include "base/Progress.h"
#include "pipeline/JobResult.h"
#include "project/OutputSets.h"

#include <QStringList>

namespace dipwright {

enum class OutputState {
    NotMade,
    Done,
    OutOfDate, // made before the last change of the project
    Failed
};

struct OutputStatus {
    Output output = Output::SheetPdf;
    OutputState state = OutputState::NotMade;
    QString reason;    // why it failed
    QStringList notes; // sentences for the user on a finished output
    // Relative to the folder. If the output failed: files that are there, but were not written now.
    QStringList files;
};

struct OutputRequest {
    QString folder;
    std::vector<Output> outputs;
    QString projectFile;     // for the print history; empty if the project was never saved
    bool overwrites = false; // also replaces files that no output made, or that were changed since
    bool acceptsClipping = false; // print files may lose colour that the printer cannot reach
};

// Returns the state of each output in the folder, for the project as it is now. Reads all their
// files. Never Failed.
std::vector<OutputStatus> outputStates(const QString& folder, const std::vector<Output>& outputs,
                                       const Project& project);
// Returns the existing files that these outputs would overwrite although no output made them, or
// although they were changed since. Reads all their files.
QStringList foreignFiles(const QString& folder, const std::vector<Output>& outputs);

// Throws Error if files cannot be written into the folder. Call it before the job.
void checkOutputsFolder(const QString& folder, const std::vector<Output>& outputs);

// Makes the outputs one after the other. The files of one output are replaced together or not at
// all, but print files one by one. An output that fails does not stop the others. Equal results
// give equal files. Throws Cancelled; outputs that were finished before stay. Reentrant for
// different folders.
std::vector<OutputStatus> makeOutputs(const JobResult& result, const OutputRequest& request,
                                      const Progress& progress);

// A line about an output for the user: its name, its state, its files or the reason, and its notes.
QString statusText(const OutputStatus& status);

} // namespace dipwright
