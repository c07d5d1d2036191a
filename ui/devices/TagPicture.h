// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include <QImage>
#include <QString>
#include <QWidget>
#include <glm/vec2.hpp>

#include "core/tracking/Picture.h"

namespace ui::devices {

/// Shows the camera's picture with the outline of the tag.
class TagPicture : public QWidget
{
    Q_OBJECT
public:
    explicit TagPicture(QWidget* parent);

    /// Corners of the tag in the picture, pixels, in the order of core::tracking::SeenTag.
    using Corners = std::array<glm::dvec2, 4>;
    /// @param tag  empty: the picture has no tag
    void setPicture(const core::tracking::Picture& picture, const std::optional<Corners>& tag);
    /// Shows text instead of a picture.
    void setWords(const QString& words);
    /// Sets whether the picture is mirrored. The default is true.
    void setMirrored(bool isMirrored);

    [[nodiscard]] bool hasPicture() const { return !m_picture.isNull(); }
    /// Returns the corners of the drawn outline in the widget; empty if there is none.
    [[nodiscard]] QPolygonF outline() const;
    [[nodiscard]] QSize sizeHint() const override { return {516, 290}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {320, 240}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void describe();
    [[nodiscard]] QRectF place() const;

    QImage m_picture;
    std::optional<Corners> m_tag;
    QString m_words;
    bool m_isMirrored = true;
};

}  // namespace ui::devices
