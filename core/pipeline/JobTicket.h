// What was computed, for the programs of whoever prints and dips it: film, motion, times, and which
// files belong to which dip.
#pragma once

#include "pipeline/JobResult.h"

#include <QJsonObject>

#include <functional>

namespace dipwright {

// The contents of a file of the results by its name in their folder; empty where it was not
// written.
using ResultContents = std::function<QByteArray(const QString&)>;

// What stands in ticket.json (docs/files-and-commands.md, "ticket.json";
// resources/schemas/ticket.schema.json). `files`: for each immersion the names of those that are to
// be printed or driven by. Nothing in it comes from the clock.
QJsonObject jobTicket(const JobResult& result, const std::vector<QStringList>& files,
                      const ResultContents& contents);

// Of a film image as sheet.png has it: the SHA-256, hexadecimal, of its pixels, row by row from the
// top, red, green and blue a byte each.
QString pictureHash(const QImage& filmImage);

} // namespace dipwright
