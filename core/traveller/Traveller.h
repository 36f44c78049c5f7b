// Makes the traveller: the printed pages, one per dip, that tell the person at the tank how to dip
// the part.
//
// The text is in the program's language; numbers use its decimal sign.
#pragma once

#include "cradle/DatumPins.h"
#include "geometry/TriangleMesh.h"
#include "settings/Immersion.h"
#include "settings/Profile.h"
#include "traveller/Motion.h"
#include "traveller/PosePicture.h"

#include <QStringList>
#include <optional>

namespace dipwright {

struct TravellerDip {
    Immersion immersion;
    QString job;                       // job number, as on the sheet's job line
    PosePicture front, right;          // the body over the film, with its cradle
    double waterAtEnd = 0;             // y of the water when the dip ends, pose frame, mm
    std::optional<QStringList> cradle; // the cradle's notes; none: no cradle was asked for
    QStringList verdict;               // sentences: first the advice, then its reasons
    QImage sheet;                      // reduced film image, ink side up
    BoundingBox body;                  // bounding box, pose frame
    QImage after;                      // how the body should look after this dip
    DipMotion motion;
};

struct Traveller {
    QString project, date;
    FilmSettings film;
    ProjectProfiles profiles;
    DatumPins pins;
    std::vector<TravellerDip> dips; // in the order of dipping
};

// Returns the job number of several sheets together, twelve hex digits: the sheet's own number for
// one sheet, else part of a SHA-256 over all numbers. `jobs` holds the sheets' job numbers, at
// least one.
QString combinedJobNumber(const QStringList& jobs);

// Returns the job number of all dips together; the QR code holds it.
QString travellerJob(const Traveller& traveller);

// Writes A4 pages, one per dip. The same traveller gives the same bytes in one language. Needs a
// QGuiApplication.
QByteArray travellerPdf(const Traveller& traveller);

} // namespace dipwright
