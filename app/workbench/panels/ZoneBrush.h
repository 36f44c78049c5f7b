// Which zone the next click on the body marks, and how far round it, and the marks that there are.
#pragma once

#include "panels/Units.h"
#include "tolerance/ToleranceSettings.h"

#include <QWidget>

#include <optional>

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;

namespace dipwright {

class ZoneBrush : public QWidget {
    Q_OBJECT

public:
    explicit ZoneBrush(LengthUnit unit, QWidget* parent = nullptr);

    // The mark of a click, without its place; none: clicks mark nothing.
    std::optional<ZoneMark> mark() const;
    void setMarkCount(std::size_t count);

signals:
    void changed();
    void removeLastAsked();
    void removeAllAsked();

private:
    LengthUnit unit_;
    QComboBox* zone_;
    QComboBox* extent_;
    QDoubleSpinBox* radius_;
    QLabel* count_;
    QPushButton* removeLast_;
    QPushButton* removeAll_;
};

} // namespace dipwright
