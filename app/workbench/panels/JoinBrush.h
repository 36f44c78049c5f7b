// What the next click on the body marks for the join of two dips, and the marks that there are.
#pragma once

#include "panels/Units.h"
#include "share/ShareSettings.h"

#include <QWidget>

#include <optional>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;

namespace dipwright {

class JoinBrush : public QWidget {
    Q_OBJECT

public:
    explicit JoinBrush(LengthUnit unit, QWidget* parent = nullptr);

    // The mark of a click, without its place; none: clicks mark nothing.
    std::optional<ShareMark> mark() const;
    void setDips(const QString& first, const QString& second); // their names
    void setMarkCount(std::size_t count);

signals:
    void changed();
    void removeLastAsked();
    void removeAllAsked();

private:
    LengthUnit unit_;
    QComboBox* kind_;
    QDoubleSpinBox* radius_;
    QCheckBox* face_;
    QLabel* count_;
    QPushButton* removeLast_;
    QPushButton* removeAll_;
};

} // namespace dipwright
