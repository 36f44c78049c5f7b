#include "accuracy/correction/SheetCorrection.h"

#include "base/Error.h"
#include "base/NumberText.h"
#include "base/WideGamut.h"
#include "parallel/ParallelFor.h"
#include "texture/LinearLight.h"

#include <Eigen/QR>
#include <Eigen/SVD>

#include <QCoreApplication>
#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::SheetCorrection)
};

constexpr double stepsInReach = 8; // makes the interpolation accurate to 0.2 %

// Returns the number of cells of the grid over this length, mm.
int cellsOver(double length, double reach) {
    return std::clamp(int(std::ceil(length / (reach / stepsInReach))), 1, 500);
}

// Interpolates the colours of an image. Places beyond the image's edges are transparent.
class Between {
public:
    explicit Between(const QImage& image) : image_(image), code_(image) {}

    // Writes the pixel for a place given in pixels from the top left corner. It is painted if the
    // nearest pixel is, with the mean of the painted pixels around the place. So edges stay hard,
    // and the bleed at the cut contour continues full colour.
    void write(uchar* pixel, double x, double y) const {
        const uchar* const nearest = pixelAt(int(std::floor(x)), int(std::floor(y)));
        if (!nearest || code_.alpha(nearest) == 0) {
            std::fill_n(pixel, code_.bytes(), uchar(0));
            return;
        }
        const int column = int(std::floor(x - 0.5)), row = int(std::floor(y - 0.5));
        const double u = x - 0.5 - column, v = y - 0.5 - row;
        Sum sum;
        for (int corner = 0; corner < 4; ++corner) {
            const bool right = corner % 2 != 0, down = corner / 2 != 0;
            add(sum, pixelAt(column + int(right), row + int(down)),
                (right ? u : 1 - u) * (down ? v : 1 - v));
        }
        const Eigen::Array3d light = sum.light / sum.alpha;
        const int alpha = int(std::lround(sum.alpha / sum.painted));
        code_.write(pixel, light.cast<float>(), std::clamp(alpha, 1, code_.opaque()));
    }
    // Writes the nearest pixel, unchanged.
    void writeNearest(uchar* pixel, double x, double y) const {
        if (const uchar* const nearest = pixelAt(int(std::floor(x)), int(std::floor(y)))) {
            std::copy_n(nearest, code_.bytes(), pixel);
        } else {
            std::fill_n(pixel, code_.bytes(), uchar(0));
        }
    }

private:
    struct Sum {
        Eigen::Array3d light = Eigen::Array3d::Zero(); // times alpha
        double alpha = 0, painted = 0;
    };

    // Returns null beyond the image's edges.
    const uchar* pixelAt(int column, int row) const {
        return image_.rect().contains(column, row)
                   ? image_.constScanLine(row) + column * code_.bytes()
                   : nullptr;
    }
    void add(Sum& sum, const uchar* pixel, double share) const {
        if (share == 0 || !pixel || code_.alpha(pixel) == 0) {
            return;
        }
        const double weight = share * code_.alpha(pixel);
        sum.light += weight * code_.light(pixel).cast<double>();
        sum.alpha += weight;
        sum.painted += share;
    }

    const QImage& image_;
    PixelCode code_;
};

// Draws an arrow on the picture of the sheet, in pixels.
void arrow(QPainter& painter, const QPointF& from, const QPointF& by, const QColor& colour,
           double thickness) {
    painter.setPen(QPen(colour, thickness, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(from, from + by);
    const double length = std::hypot(by.x(), by.y());
    if (length > 0) {
        const double head = std::min(length / 3, 3 * thickness);
        const QPointF back = -by / length * head, across(-back.y(), back.x());
        painter.drawLine(from + by, from + by + back + across / 2);
        painter.drawLine(from + by, from + by + back - across / 2);
    }
}

// Returns the error at each measured place, mm.
Eigen::MatrixX2d errorsAtPlaces(const RepeatingError& error) {
    Eigen::MatrixX2d errors(Eigen::Index(error.places().size()), 2);
    for (Eigen::Index row = 0; row < errors.rows(); ++row) {
        errors.row(row) = error.at(error.places()[std::size_t(row)].sheet).transpose();
    }
    return errors;
}

double largestOf(const Eigen::MatrixX2d& errors) {
    return errors.rows() > 0 ? errors.rowwise().norm().maxCoeff() : 0;
}

// Returns the largest relative change of a length by the affine map that fits `errors`, at the
// measured places, best; 0 if there are too few places.
double lengthChangeOf(const RepeatingError& error, const Eigen::MatrixX2d& errors) {
    Eigen::MatrixX3d places(errors.rows(), 3);
    for (Eigen::Index row = 0; row < places.rows(); ++row) {
        const Eigen::Vector2d& sheet = error.places()[std::size_t(row)].sheet;
        places.row(row) << sheet.x(), sheet.y(), 1;
    }
    const Eigen::ColPivHouseholderQR<Eigen::MatrixX3d> fit(places);
    if (places.rows() < 3 || fit.rank() < 3) {
        return 0;
    }
    const Eigen::Matrix<double, 3, 2> map = fit.solve(errors);
    return Eigen::JacobiSVD<Eigen::Matrix2d>(map.topRows<2>()).singularValues()[0];
}

QString figuresOf(const RepeatingError& error, const Eigen::MatrixX2d& errors, int dip) {
    const double most = largestOf(errors);
    if (error.parts() < 2) {
        return Text::tr("Dip %1: %2 places measured on one part, errors up to %3 mm. Measure three "
                        "parts or more to see which errors repeat.")
            .arg(dip)
            .arg(error.places().size())
            .arg(numberText(most, 2));
    }
    return Text::tr("Dip %1: %2 places measured on %3 parts. The repeating error is up to %4 mm; "
                    "places less than %5 mm apart have similar errors. Scatter: %6 mm for single "
                    "places, %7 mm for whole parts.")
        .arg(dip)
        .arg(error.places().size())
        .arg(error.parts())
        .arg(numberText(most, 2), numberText(error.reach(), 0), numberText(error.scatter(), 2),
             numberText(error.partScatter(), 2));
}

QString unusualErrorNote(const RepeatingError& error, const Eigen::MatrixX2d& errors) {
    const double most = largestOf(errors), change = lengthChangeOf(error, errors);
    if (most <= mostUsualError && change <= mostUsualLengthChange) {
        return {};
    }
    return Text::tr("The measured parts move the picture by up to %1 mm and change lengths by %2 "
                    "%. More than %3 mm or %4 % is unusual. Check the measured places, or turn the "
                    "correction off.")
        .arg(numberText(most, 2), numberText(100 * change, 0), numberText(mostUsualError, 0),
             numberText(100 * mostUsualLengthChange, 0));
}

} // namespace

bool isCorrected(const AsBuilt& built, int dip) {
    return built.corrects && built.strength > 0 &&
           std::any_of(built.places.begin(), built.places.end(),
                       [dip](const BuiltPlace& place) { return place.dip == dip; });
}

DenseError::DenseError(const RepeatingError& error, Millimetres width, Millimetres height)
    : size_(width.value(), height.value()), columns_(cellsOver(size_.x(), error.reach())),
      rows_(cellsOver(size_.y(), error.reach())),
      values_(std::size_t(columns_ + 1) * std::size_t(rows_ + 1)) {
    parallelFor(std::size_t(0), values_.size(), [&](std::size_t number) {
        const int column = int(number) % (columns_ + 1), row = int(number) / (columns_ + 1);
        values_[number] = error.at({size_.x() * (double(column) / columns_ - 0.5),
                                    size_.y() * (double(row) / rows_ - 0.5)});
    });
}

Eigen::Vector2d DenseError::at(double right, double down) const {
    const double x = std::clamp(right, 0.0, 1.0) * columns_;
    const double y = std::clamp(down, 0.0, 1.0) * rows_;
    const int column = std::min(int(x), columns_ - 1), row = std::min(int(y), rows_ - 1);
    const double u = x - column, v = y - row;
    return (1 - v) * ((1 - u) * value(column, row) + u * value(column + 1, row)) +
           v * ((1 - u) * value(column, row + 1) + u * value(column + 1, row + 1));
}

double DenseError::gradient() const {
    const Eigen::Vector2d cell(size_.x() / columns_, size_.y() / rows_);
    double most = 0;
    for (int row = 0; row < rows_; ++row) {
        for (int column = 0; column < columns_; ++column) {
            Eigen::Matrix2d slope;
            slope << (value(column + 1, row) - value(column, row)) / cell.x(),
                (value(column, row + 1) - value(column, row)) / cell.y();
            most = std::max(most, Eigen::JacobiSVD<Eigen::Matrix2d>(slope).singularValues()[0]);
        }
    }
    return most;
}

void requirePossibleErrors(const AsBuilt& built, Millimetres width, Millimetres height,
                           const QString& where) {
    for (const int dip : {1, 2}) {
        const RepeatingError error(built, dip);
        if (!error.isNothing() && DenseError(error, width, height).gradient() > mostErrorGradient) {
            throw Error(
                Text::tr("The measured errors of dip %1 contradict each other, so a correction "
                         "would fold or mirror the sheet; check the measured places, or remove "
                         "the part from the job or turn the correction off")
                    .arg(dip),
                where);
        }
    }
}

QImage correctedImage(const QImage& filmImage, const DenseError& error, double strength,
                      Resampling resampling) {
    const QImage from =
        isWide(filmImage) ? filmImage : filmImage.convertToFormat(QImage::Format_RGBA8888);
    const std::ptrdiff_t pixelBytes = PixelCode(from).bytes();
    QImage to(from.size(), from.format());
    to.setColorSpace(from.colorSpace());
    to.setDotsPerMeterX(from.dotsPerMeterX());
    to.setDotsPerMeterY(from.dotsPerMeterY());
    const Between colours(from);
    const Eigen::Array2d pixelsPerMillimetre(from.width() / error.size().x(),
                                             from.height() / error.size().y());
    uchar* const bits = to.bits();
    const auto stride = to.bytesPerLine();
    parallelFor(0, to.height(), [&](int row) {
        uchar* pixel = bits + row * stride;
        for (int column = 0; column < to.width(); ++column, pixel += pixelBytes) {
            const Eigen::Array2d place(column + 0.5, row + 0.5);
            const Eigen::Array2d by = error.at(place.x() / to.width(), place.y() / to.height());
            const Eigen::Array2d at = place + strength * by * pixelsPerMillimetre;
            if (resampling == Resampling::Nearest) {
                colours.writeNearest(pixel, at.x(), at.y());
            } else {
                colours.write(pixel, at.x(), at.y());
            }
        }
    });
    return to;
}

QImage correctedTints(const QImage& tints, const DenseError& error, double strength) {
    QImage alpha = tints;
    alpha.reinterpretAsFormat(QImage::Format_Alpha8);
    QImage moved = correctedImage(alpha, error, strength).convertToFormat(QImage::Format_Alpha8);
    moved.reinterpretAsFormat(QImage::Format_Grayscale8);
    return moved;
}

Eigen::Vector2d printedAt(const Eigen::Vector2d& place, const RepeatingError& error,
                          double strength) {
    constexpr int rounds = 20; // each round changes the result by about 10 % of the previous change
    Eigen::Vector2d at = place;
    for (int round = 0; round < rounds; ++round) {
        at = place - strength * error.at(at);
    }
    return at;
}

QString unusualErrorNote(const RepeatingError& error) {
    return unusualErrorNote(error, errorsAtPlaces(error));
}

QString repeatingSentence(const RepeatingError& error, int dip) {
    const Eigen::MatrixX2d errors = errorsAtPlaces(error);
    const QString note = unusualErrorNote(error, errors);
    const QString figures = figuresOf(error, errors, dip);
    return note.isEmpty() ? figures : QStringLiteral("%1 %2").arg(figures, note);
}

QImage correctionPicture(const RepeatingError& error, Millimetres width, Millimetres height,
                         double strength, int pixels) {
    const double scale = 0.88 * pixels / height.value(); // pixels per mm of the sheet
    const double unit = pixels / 100.0;
    QImage picture(int(width.value() * scale + 8 * unit), pixels, QImage::Format_RGB32);
    picture.fill(Qt::white);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF sheet(4 * unit, 8 * unit, width.value() * scale, height.value() * scale);
    painter.setPen(QPen(QColor(150, 155, 160), unit / 6));
    painter.drawRect(sheet);
    double longest = 1e-3;
    for (const RepeatedPlace& place : error.places()) {
        longest = std::max(longest, place.mean.norm());
    }
    const double times = std::pow(10, std::floor(std::log10(height.value() / 12 / longest)));
    const auto placed = [&](const Eigen::Vector2d& place) {
        return sheet.center() + scale * QPointF(place.x(), place.y());
    };
    constexpr int across = 15;
    for (int i = 0; i < across * across * 2; ++i) {
        const Eigen::Vector2d place(width.value() * ((i % across + 0.5) / across - 0.5),
                                    height.value() * ((i / across + 0.5) / (2 * across) - 0.5));
        const Eigen::Vector2d by = -times * strength * error.at(place);
        arrow(painter, placed(place), scale * QPointF(by.x(), by.y()), QColor(150, 175, 205),
              unit / 7);
    }
    for (const RepeatedPlace& place : error.places()) {
        const Eigen::Vector2d by = times * place.mean;
        arrow(painter, placed(place.sheet), scale * QPointF(by.x(), by.y()), QColor(190, 40, 60),
              unit / 5);
        painter.drawEllipse(placed(place.sheet), unit / 4, unit / 4);
    }
    QFont font(QStringLiteral("DejaVu Sans"));
    font.setPixelSize(std::max(8, int(1.8 * unit)));
    painter.setFont(font);
    painter.setPen(QColor(40, 44, 50));
    painter.drawText(QPointF(4 * unit, 4 * unit),
                     Text::tr("Red: mean measured error (parts: %1), scale %2:1")
                         .arg(error.parts())
                         .arg(numberText(times, 0)));
    painter.drawText(QPointF(4 * unit, 6.8 * unit),
                     Text::tr("Blue: correction of the next sheet, to the same scale"));
    return picture;
}

} // namespace dipwright
