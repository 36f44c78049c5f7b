// Makes the job ticket for the programs that print and dip: film, motion, times, and the files of
// each dip.
#pragma once

#include "pipeline/JobResult.h"

#include <QJsonObject>

#include <functional>

namespace dipwright {

// Returns the contents of a result file by its name in the results' folder; empty if it was not
// written.
using ResultContents = std::function<QByteArray(const QString&)>;

// Returns the contents of ticket.json (docs/files-and-commands.md, "ticket.json";
// resources/schemas/ticket.schema.json). `files` holds, for each immersion, the names of its sheet
// and motion files. The result does not depend on the clock.
QJsonObject jobTicket(const JobResult& result, const std::vector<QStringList>& files,
                      const ResultContents& contents);

// Returns the hexadecimal SHA-256 of a film image's pixels as in sheet.png: rows from the top, one
// byte each for red, green and blue.
QString pictureHash(const QImage& filmImage);

} // namespace dipwright
