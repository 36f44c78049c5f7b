// Takes, removes and restores snapshots of an open project (project/Snapshots.h), each as one undo
// step.
#pragma once

#include "project/Snapshots.h"
#include "workbench/document/Document.h"

namespace dipwright {

// Returns the figures by which states are compared: "painted" (share of the body's surface that is
// painted), "stretch" (95th percentile over the film on the body, largest of all dips),
// "uncertain_mm2" (area with too large a numerical error). Empty without a result that fits the
// project.
QJsonObject snapshotMeasures(const Document& document);

void takeSnapshot(Document& document, const QString& name);
void removeSnapshot(Document& document, std::size_t number);
// Throws Error if the snapshot holds values that a project may not have.
void restoreSnapshot(Document& document, std::size_t number);

} // namespace dipwright
