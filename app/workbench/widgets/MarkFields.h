// Chooses what a click or drag on the body in the view marks, with which radius, and whether it
// erases. The keys [ and ] change the radius. Counts and removes the marks.
#pragma once

#include "workbench/document/MarkEdits.h"
#include "workbench/widgets/Units.h"

#include <QWidget>

class QAbstractButton;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QPushButton;
class QSlider;

namespace dipwright {

class MarkFields : public QWidget {
    Q_OBJECT

public:
    // `name`: prefix of the fields' object names.
    MarkFields(const QString& name, LengthUnit unit, QWidget* parent);

    // The brush, which is an eraser if the user asks for one.
    MarkBrush brush() const;
    void setMarkCount(std::size_t count);
    // Lets the user choose a face or material by its name. Without names, the choice is hidden.
    void setNames(const QStringList& names);

signals:
    void changed();                       // the brush
    void nameChosen(const QString& name); // the user asks to mark it with the brush
    void removeLastAsked();
    void removeAllAsked();

protected:
    virtual MarkBrush chosen() const = 0; // the brush that the fields describe
    // The kinds of marks. The first entry is already there and marks nothing.
    QComboBox& kind() { return *kind_; }
    const QComboBox& kind() const { return *kind_; }
    static constexpr int noKind = -1; // the first entry's data
    Millimetres radius() const;
    // Without a radius, a click marks as much as the brush covers, and cannot erase.
    void setRadiusEnabled(bool enabled);
    // Inserts a field above row `row`, also for the Tab key. `label`: empty for a field without
    // one.
    void insertField(int row, const QString& label, QWidget& field);
    static constexpr int radiusRow = 1; // unless rows were inserted above it

private:
    void addNames();
    void resize(double factor);
    void showRadius();

    LengthUnit unit_;
    QFormLayout* form_;
    QComboBox* kind_;
    QDoubleSpinBox* radius_;
    QSlider* size_; // the radius on a logarithmic scale
    QAbstractButton* eraser_;
    QWidget* byName_; // the row of names_ and mark_
    QComboBox* names_;
    QPushButton* mark_;
    QLabel* count_;
    QPushButton* removeLast_;
    QPushButton* removeAll_;
};

} // namespace dipwright
