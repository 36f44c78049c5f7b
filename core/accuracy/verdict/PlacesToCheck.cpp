#include "accuracy/verdict/PlacesToCheck.h"

#include "geometry/JoinedPositions.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace dipwright {
namespace {

double area(const FilmContact& contact, const FilmTriangle& corners) {
    const Eigen::Vector3f a = contact.places[corners[0]];
    const Eigen::Vector3f b = contact.places[corners[1]];
    const Eigen::Vector3f c = contact.places[corners[2]];
    return double((b - a).cross(c - a).norm()) / 2;
}

struct Piece {
    double offBy = 0, area = 0;
};

// The painted film in one zone of one body.
struct ZoneFilm {
    std::vector<Piece> pieces; // whose error is known
    double unknown = 0;        // mm²

    void add(const ZoneFilm& other) {
        pieces.insert(pieces.end(), other.pieces.begin(), other.pieces.end());
        unknown += other.unknown;
    }
    bool isEmpty() const { return pieces.empty() && unknown == 0; }
};

// A triangle of painted film that needs a check.
struct PieceToCheck {
    FilmTriangle corners;
    double offBy = 0, area = 0, limit = 0;
};

class PaintedFilm {
public:
    PaintedFilm(const LaidFilm& laid, const std::vector<float>& pointErrors,
                const JudgedSurface& surface, const ToleranceSettings& settings)
        : laid_(laid), offBy_(pointErrors), surface_(surface), settings_(settings),
          parts_(laid.film().positions.size()),
          films_(surface.bodies ? std::size_t(surface.bodies->names.size()) : 1) {
        for (std::size_t triangle = 0; triangle < laid.triangles().size(); ++triangle) {
            if (laid.contact().painted[triangle] && !isMasked(laid, triangle, surface.mask)) {
                add(std::uint32_t(triangle));
            }
        }
    }

    std::vector<ZoneError> zoneErrors() const {
        std::vector<ZoneError> errors;
        for (std::size_t zone = 0; zone < zoneCount; ++zone) {
            ZoneFilm all;
            for (const auto& zones : films_) {
                all.add(zones[zone]);
            }
            if (!all.isEmpty()) {
                errors.push_back(errorOf(Zone(zone), std::move(all)));
            }
        }
        return errors;
    }

    std::vector<ZoneError> zoneErrorsOfBodies() const {
        std::vector<ZoneError> errors;
        for (std::size_t body = 0; surface_.bodies && body < films_.size(); ++body) {
            for (std::size_t zone = 0; zone < zoneCount; ++zone) {
                ZoneError error = errorOf(Zone(zone), films_[body][zone]);
                if (error.area + films_[body][zone].unknown >= leastPlaceArea) {
                    error.body = surface_.bodies->names[qsizetype(body)];
                    errors.push_back(std::move(error));
                }
            }
        }
        return errors;
    }

    std::vector<PlaceToCheck> places() {
        std::map<std::uint32_t, PlaceToCheck> byPart; // key: the set's first point
        for (const PieceToCheck& piece : uncertain_) {
            PlaceToCheck& place = byPart[parts_.pieceOf(piece.corners[0])];
            const bool isFirst = place.area == 0;
            place.area += piece.area;
            place.limit = isFirst ? piece.limit : std::min(place.limit, piece.limit);
            if (isFirst || piece.offBy > place.offBy) {
                place.offBy = piece.offBy;
                const auto& [a, b, c] = piece.corners;
                const solver::FilmGrid& grid = laid_.film().grid;
                const std::vector<Eigen::Vector3f>& points = laid_.contact().places;
                place.rest =
                    (restPosition(grid, a) + restPosition(grid, b) + restPosition(grid, c)) / 3;
                place.place = onModel((points[a] + points[b] + points[c]) / 3);
            }
        }
        std::vector<PlaceToCheck> places;
        for (const auto& [part, place] : byPart) {
            if (place.area >= leastPlaceArea) {
                places.push_back(place);
            }
        }
        std::stable_sort(places.begin(), places.end(),
                         [](const auto& a, const auto& b) { return a.area > b.area; });
        places.resize(std::min(places.size(), mostPlaces));
        return places;
    }

    double areaToCheck() const {
        return std::accumulate(uncertain_.begin(), uncertain_.end(), 0.0,
                               [](double sum, const auto& piece) { return sum + piece.area; });
    }

private:
    static bool isMasked(const LaidFilm& laid, std::size_t triangle, const SurfaceMask* mask) {
        const FilmTriangle& corners = laid.triangles()[triangle];
        return mask && std::all_of(corners.begin(), corners.end(), [&](std::uint32_t point) {
                   const SurfacePoint& place = laid.contact().surface[point];
                   return place.isValid() && mask->covers(place);
               });
    }
    void add(std::uint32_t triangle) {
        const FilmTriangle& corners = laid_.triangles()[triangle];
        const double here = area(laid_.contact(), corners);
        const Zone zone = zoneOf(corners);
        const double limit = allowedError(zone, settings_);
        double worst = 0;
        bool isKnown = false;
        for (const std::uint32_t point : corners) {
            worst = std::max(worst, offBy(point));
            isKnown = isKnown || (!offBy_.empty() && !std::isnan(offBy_[point]));
        }
        ZoneFilm& film = films_[bodyOf(corners)][std::size_t(zone)];
        if (isKnown) {
            film.pieces.push_back({worst, here});
        } else {
            film.unknown += here;
        }
        if (worst > limit || has(laid_.marks(triangle), solver::PointMark::Unbalanced)) {
            uncertain_.push_back({corners, worst, here, limit});
            parts_.join(corners[0], corners[1]);
            parts_.join(corners[0], corners[2]);
        }
    }

    ZoneError errorOf(Zone zone, ZoneFilm film) const {
        std::ranges::sort(film.pieces, {}, &Piece::offBy);
        ZoneError error{zone, {}, settings_.limits[std::size_t(zone)].value()};
        for (const Piece& piece : film.pieces) {
            error.area += piece.area;
            error.far += piece.offBy > error.limit ? piece.area : 0;
        }
        const double unknown = film.unknown;
        error.unknown = unknown > 0 ? unknown / (error.area + unknown) : 0;
        const double within =
            zoneShareWithin * (error.area + (error.unknown > mostUnknownArea ? 0 : unknown));
        double below = 0;
        for (const Piece& piece : film.pieces) {
            below += piece.area;
            error.percentile95 = piece.offBy;
            if (below >= within) {
                break;
            }
        }
        error.far = error.area > 0 ? error.far / error.area : 0;
        return error;
    }

    Zone zoneOf(const FilmTriangle& corners) const {
        for (const std::uint32_t point : corners) {
            const SurfacePoint& place = laid_.contact().surface[point];
            if (surface_.zones && place.isValid()) {
                return surface_.zones->at(place);
            }
        }
        return Zone::C;
    }

    std::size_t bodyOf(const FilmTriangle& corners) const {
        for (const std::uint32_t point : corners) {
            const SurfacePoint& place = laid_.contact().surface[point];
            if (surface_.bodies && place.isValid()) {
                return surface_.bodies->ofTriangle[place.triangle];
            }
        }
        return 0;
    }

    // An unknown error counts as 0. At the border of the paint, Kind::Border judges it; if it is
    // unknown everywhere, Kind::NothingAlike forbids the sheet.
    double offBy(std::uint32_t point) const {
        return offBy_.empty() || std::isnan(offBy_[point]) ? 0 : double(offBy_[point]);
    }

    Eigen::Vector3f onModel(const Eigen::Vector3f& place) const {
        return laid_.body().modelToPose.inverse().cast<float>() * place;
    }

    const LaidFilm& laid_;
    const std::vector<float>& offBy_;
    const JudgedSurface& surface_;
    const ToleranceSettings& settings_;
    JoinedPositions parts_;                              // of uncertain film
    std::vector<std::array<ZoneFilm, zoneCount>> films_; // of each body
    std::vector<PieceToCheck> uncertain_;
};

} // namespace

PlacesToCheck placesToCheck(const LaidFilm& laid, const std::vector<float>& pointErrors,
                            const JudgedSurface& surface, const ToleranceSettings& settings) {
    PaintedFilm film(laid, pointErrors, surface, settings);
    return {film.zoneErrors(), film.zoneErrorsOfBodies(), film.places(), film.areaToCheck()};
}

} // namespace dipwright
