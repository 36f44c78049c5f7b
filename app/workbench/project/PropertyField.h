// Edits one value of a project or profile with a spin box, a combo box, a check box or a line of
// text. The value's schema rule decides which.
#pragma once

#include "project/Field.h"
#include "workbench/widgets/Units.h"

#include <QWidget>
#include <functional>
#include <memory>

namespace dipwright {

struct Project;

// Label, explanation and unit of a schema value.
struct PropertySpec {
    QString path;
    QString label;
    QString help; // one or two sentences
    Unit unit = Unit::None;
    QStringList parts = {};            // short names of the components: "X", "Y"
    QMap<QString, QString> words = {}; // the schema's choices in the user's language
    QString absent = {};               // what a missing value means: "Elastic"
    double whenPresent = 1;            // the value when the user sets one
    std::function<bool(const Project&)> relevant = {}; // empty: always shown
    // The components usually have the same value. Typing one component sets all, unless the user
    // unlinks them.
    bool linked = false;
    bool isColour = false; // a text such as "#rrggbb", with a colour dialog
};

class PropertyField : public QWidget {
    Q_OBJECT

public:
    static PropertyField* make(const PropertySpec& spec, const FieldRule& rule, LengthUnit length,
                               QWidget* parent);

    virtual void show(const QJsonValue& value) = 0; // emits nothing
    const PropertySpec& spec() const { return spec_; }

signals:
    void edited(const QJsonValue& value);
    void left();                           // the focus went elsewhere, or a number was entered
    void refused(const QString& sentence); // the typed value was not accepted

protected:
    PropertyField(const PropertySpec& spec, QWidget* parent) : QWidget(parent), spec_(spec) {}
    // Names and explains an editor, and watches when it loses the focus.
    void adopt(QWidget* editor, const QString& name, const QString& range);
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    PropertySpec spec_;
};

} // namespace dipwright
