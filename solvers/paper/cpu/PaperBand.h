// A band of the film's rows, worked on by one thread through several Jacobi or Gauss–Seidel sweeps
// before the next barrier with the other bands. It computes the rows beside it that it needs once
// more itself, with the same arithmetic, so that the result does not depend on how the film is cut.
#pragma once

#include "paper/cpu/PaperModel.h"

namespace dipwright::cpu {

// What all bands do between two barriers.
struct PaperPass {
    bool predicts = false; // begins with the prediction and the contact
    int sweeps = 0;
    double descent = 0;                // of the body, mm
    numerics::BodyFrame<double> frame; // at that descent
};

// The points as bands share them: each writes its own rows of `film`, and leaves those that its
// neighbours will read in `published`, one of which is read while the other is written.
struct SharedFilm {
    FilmRows film;
    std::array<FilmRows, 2> published;
    int read = 0;
    FilmActivity activity;
};

// Rows beside a band that one sweep reads.
int rowsPerSweep(solver::Relaxation relaxation);

class PaperBand {
public:
    // Rows first … last − 1, first even; `sweeps` is the most that a pass may have.
    PaperBand(const PaperModel& model, SharedFilm& shared, int first, int last, int sweeps);

    void run(const PaperPass& pass);

private:
    // How the points of a chunk and the body come near each other. A distance field tells how far
    // they can travel before they may touch, and until then nothing need be sampled.
    struct Approach {
        float travelled = 0; // mm by body and film together, at most
        float nearest = 0;   // the smallest of `points`
        std::array<float, chunkColumns>
            points{}; // the travel at which each is as near as its φ tells

        bool isNear(float margin) const { return nearest <= travelled + margin; }
    };

    void runJacobi();
    void jacobi(int row, int sweep);
    void jacobi(int row, int sweep, const std::uint8_t* isBusy);

    void runGaussSeidel();
    void gaussSeidel(int pair, bool hasPairAbove);
    void solveAlongRow(int row);
    void solveBetweenRows(int row);
    void solve(const WorkingRow& first, const WorkingRow& second, std::array<float, 2> rest,
               float length, float stiffness, const AlignedVector<float>& exists) const;

    void load(int row);
    void store(int row);
    void findContacts(int row, int chunk);
    void adhere(int row, int column, numerics::Vector3<double> place);

    bool isOwn(int row) const { return row >= first_ && row < last_; }
    bool isReadByNeighbour(int row) const;
    bool splitsColumns() const {
        return model_.settings.relaxation == solver::Relaxation::GaussSeidel;
    }
    WorkingRow working(int row);
    Approach* approaches(int row);

    const PaperModel& model_;
    SharedFilm& shared_;
    const int first_, last_;
    const int reach_; // rows on either side that are computed once more
    const int firstLoaded_, lastLoaded_;
    const int ringRows_;
    PaperPass pass_;
    AlignedVector<float> ring_;      // the working rows in use
    AlignedVector<float> unsplit_;   // a working row before its columns are split by parity
    AlignedVector<float> noRow_;     // points of weight 0
    AlignedVector<float> fromAbove_; // three arrays a sweep
    AlignedVector<float> evenHasRight_, oddHasRight_, allExist_; // per pair of columns
    std::vector<Approach> approaches_;                           // per loaded row and chunk
    std::vector<float> motion_; // per chunk of the row being loaded
    std::vector<std::uint8_t> isNeeded_;
};

} // namespace dipwright::cpu
