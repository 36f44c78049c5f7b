#include "workbench/poses/OrientationMap.h"

#include "results/Results.h"

#include <QHelpEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>
#include <cmath>

namespace dipwright {

namespace {

constexpr int margin = 6;          // pixels round the disc
constexpr int ringRadius = 5;      // around a selected pose
constexpr double narrowest = 0.02; // smallest range of objectives for the colours

} // namespace

OrientationMap::OrientationMap(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("orientationMap"));
    setAccessibleName(tr("Rating of each side when it goes down first"));
    setCursor(Qt::CrossCursor);
    QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Preferred);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
}

void OrientationMap::setDirections(std::vector<TriedDirection> directions) {
    std::erase_if(directions, [](const TriedDirection& tried) { return !tried.objective; });
    directions_ = std::move(directions);
    lowest_ = 1;
    highest_ = 0;
    for (const TriedDirection& tried : directions_) {
        lowest_ = std::min(lowest_, *tried.objective);
        highest_ = std::max(highest_, *tried.objective);
    }
    lowest_ = std::min(lowest_, highest_ - narrowest);
    draw();
}

void OrientationMap::setChosen(std::vector<Eigen::Vector3d> downs) {
    chosen_ = std::move(downs);
    update();
}

double OrientationMap::radius() const {
    return std::max(1, std::min(width(), height()) / 2 - margin);
}

// Lambert's azimuthal projection of the whole sphere, centred on −Y.
QPointF OrientationMap::placeOf(const Eigen::Vector3d& down) const {
    const double across = std::hypot(down.x(), down.z());
    // Distance from the centre divided by the radius.
    const double share = std::sqrt((1 + down.y()) / 2);
    const double right = across > 0 ? down.x() / across : 1,
                 below = across > 0 ? down.z() / across : 0;
    return rect().toRectF().center() + radius() * share * QPointF(right, below);
}

std::optional<Eigen::Vector3d> OrientationMap::directionAt(QPointF place) const {
    const QPointF from = (place - rect().toRectF().center()) / radius();
    const double share = std::hypot(from.x(), from.y());
    if (share > 1) {
        return std::nullopt;
    }
    const double y = 2 * share * share - 1;
    const double across = share > 0 ? std::sqrt(std::max(0.0, 1 - y * y)) / share : 0;
    return Eigen::Vector3d(across * from.x(), y, across * from.y());
}

const TriedDirection* OrientationMap::nearest(const Eigen::Vector3d& down) const {
    const auto found =
        std::max_element(directions_.begin(), directions_.end(),
                         [&](const TriedDirection& one, const TriedDirection& other) {
                             return one.down.dot(down) < other.down.dot(down);
                         });
    return found == directions_.end() ? nullptr : &*found;
}

void OrientationMap::draw() {
    picture_ = QImage(size(), QImage::Format_ARGB32);
    picture_.fill(Qt::transparent);
    if (!directions_.empty()) {
        for (int y = 0; y < height(); ++y) {
            auto* line = reinterpret_cast<QRgb*>(picture_.scanLine(y));
            for (int x = 0; x < width(); ++x) {
                if (const auto down = directionAt(QPointF(x + 0.5, y + 0.5))) {
                    const double objective = *nearest(*down)->objective;
                    line[x] = mapColour(QStringLiteral("lagoon"),
                                        (objective - lowest_) / (highest_ - lowest_))
                                  .rgb();
                }
            }
        }
    }
    update();
}

void OrientationMap::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    draw();
}

void OrientationMap::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.drawImage(0, 0, picture_);
    painter.setPen(QPen(palette().color(QPalette::Mid), 1));
    painter.drawEllipse(rect().toRectF().center(), radius(), radius());
    if (directions_.empty()) {
        painter.setPen(palette().color(QPalette::PlaceholderText));
        painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap,
                         tr("Which side\ngoes down first"));
    }
    for (const Eigen::Vector3d& down : chosen_) { // black and white, visible on any colour
        painter.setPen(QPen(Qt::black, 4));
        painter.drawEllipse(placeOf(down), ringRadius, ringRadius);
        painter.setPen(QPen(Qt::white, 2));
        painter.drawEllipse(placeOf(down), ringRadius, ringRadius);
    }
}

void OrientationMap::mousePressEvent(QMouseEvent* event) {
    const auto down = directionAt(event->position());
    const TriedDirection* tried = down ? nearest(*down) : nullptr;
    if (tried && event->button() == Qt::LeftButton) {
        emit picked(tried->down);
    }
}

bool OrientationMap::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        auto& help = static_cast<QHelpEvent&>(*event);
        const auto down = directionAt(help.pos());
        if (const TriedDirection* tried = down ? nearest(*down) : nullptr) {
            QToolTip::showText(help.globalPos(),
                               tr("Objective %1; click to turn this side down")
                                   .arg(locale().toString(100 * *tried->objective, 'f', 1)),
                               this);
            return true;
        }
    }
    return QWidget::event(event);
}

} // namespace dipwright
