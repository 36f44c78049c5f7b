// Snapshots of an open project (project/Snapshots.h): taken, removed and gone back to, each a step
// to undo.
#pragma once

#include "project/Snapshots.h"
#include "workbench/document/Document.h"

namespace dipwright {

// Figures of a result to compare states by: "painted" (share of the body), "stretch" (the largest
// that 95 % of the film on the body keeps, of all dips), "uncertain_mm2". Empty for none.
QJsonObject snapshotMeasures(const Document& document); // of a result that fits the project

void takeSnapshot(Document& document, const QString& name);
void removeSnapshot(Document& document, std::size_t number);
// Throws Error where the snapshot holds what no project may.
void goBackTo(Document& document, std::size_t number);

} // namespace dipwright
