// What poses are searched for.
#pragma once

#include "model/TexturedMesh.h"
#include "settings/FilmSettings.h"
#include "settings/Immersion.h"
#include "settings/ProcessSettings.h"
#include "settings/ToleranceSettings.h"

#include <QByteArray>
#include <memory>
#include <vector>

namespace dipwright {

struct TexturedMesh;

struct SearchSubject {
    QString name;
    QByteArray identity; // the same for the same model, artwork, film, process, zones and solver;
                         // ties parts together
    std::shared_ptr<const TexturedMesh> model; // never null; as it is to look
    bool isWhitePrinted = false;               // what is to be white needs film as well
    FilmSettings film;
    ProcessSettings process;
    int fieldResolution = 128;
    std::vector<ZoneMark> marks;        // zones that matter more
    Millimetres registrationError{0.7}; // of two dips against each other, to be prepared for
    std::vector<Immersion> immersions;  // the job's own poses
};

} // namespace dipwright
