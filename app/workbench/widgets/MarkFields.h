// Chooses what a click on the body in the view marks, and with which radius. Lists and removes the
// marks.
#pragma once

#include "workbench/document/MarkEdits.h"
#include "workbench/widgets/Units.h"

#include <QWidget>

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QPushButton;

namespace dipwright {

class MarkFields : public QWidget {
    Q_OBJECT

public:
    // `name`: prefix of the fields' object names.
    MarkFields(const QString& name, LengthUnit unit, QWidget* parent);

    virtual MarkBrush brush() const = 0;
    void setMarkCount(std::size_t count);

signals:
    void changed(); // the brush
    void removeLastAsked();
    void removeAllAsked();

protected:
    // The kinds of marks. The first entry is already there and marks nothing.
    QComboBox& kind() { return *kind_; }
    const QComboBox& kind() const { return *kind_; }
    static constexpr int noKind = -1; // the first entry's data
    Millimetres radius() const;
    void setRadiusEnabled(bool enabled);
    // The layout. Subclasses insert fields between the kind and the radius, or add unlabelled
    // fields below the radius.
    QFormLayout& form() { return *form_; }
    static constexpr int radiusRow = 1; // unless rows were inserted above it

private:
    LengthUnit unit_;
    QFormLayout* form_;
    QComboBox* kind_;
    QDoubleSpinBox* radius_;
    QLabel* count_;
    QPushButton* removeLast_;
    QPushButton* removeAll_;
};

} // namespace dipwright
