// How every value of the schema is called and explained, by the part of the project it belongs to.
#pragma once

#include "project/FilmFields.h"
#include "workbench/project/ProjectTree.h"
#include "workbench/project/PropertyField.h"

namespace dipwright {

struct Project;

struct PropertySection {
    QString title; // empty: none
    std::vector<PropertySpec> specs;
};

// Describes the field of the film's material at `path`.
PropertySpec specOf(const QString& path, const FieldWords& words);

// "Film", "Dipping"; of the project and of an immersion: their own names.
QString partName(const ProjectNode& node, const Project& project);

std::vector<PropertySection> propertySections(const ProjectNode& node);

// Where the field of this path stands; nothing where no part shows it.
std::optional<ProjectNode> nodeOfField(const QString& path);

} // namespace dipwright
