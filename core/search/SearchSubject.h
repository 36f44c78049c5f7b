// The input of a pose search.
#pragma once

#include "marks/SurfaceMask.h"
#include "model/TexturedMesh.h"
#include "settings/FilmSettings.h"
#include "settings/Immersion.h"
#include "settings/InkSettings.h"
#include "settings/ProcessSettings.h"
#include "settings/Profile.h"
#include "settings/ToleranceSettings.h"
#include "settings/VerdictSettings.h"

#include <QByteArray>
#include <memory>
#include <vector>

namespace dipwright {

struct TexturedMesh;

struct SearchSubject {
    QString name;
    // Two subjects have the same identity if their model with its textures, artwork, white layer,
    // film, process, zones, masks, ink and solver are equal. The identity shows which shards belong
    // to one search.
    QByteArray identity;
    std::shared_ptr<const TexturedMesh> model; // with its artwork; never null
    bool isWhitePrinted = false;               // then white places need film, too
    FilmSettings film;
    ProcessSettings process;
    int fieldResolution = 128;
    ToleranceSettings tolerance; // marked zones and their limits
    // Surface that needs no film, of `model`; null: none.
    std::shared_ptr<const SurfaceMask> mask = {};
    VerdictSettings verdict;            // limits for the verdict on confirmed poses
    InkSettings ink;                    // decides where the film stretches more than ink can cover
    Millimetres registrationError{0.7}; // expected position error of dip 2
    // Poses that exceed its limits rank after all others; none: no limits.
    std::optional<TankProfile> tank;
    std::vector<Immersion> immersions; // the job's own poses
};

} // namespace dipwright
