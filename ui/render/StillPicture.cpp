// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/render/StillPicture.h"

#include <utility>

namespace ui::render {

bool StillPicture::holds(QSize size, const StillView& view) const
{
    return m_pixels && m_pixels->size() == size && m_view == view;
}

void StillPicture::take(QSize size, const StillView& view)
{
    if (!m_pixels || m_pixels->size() != size)
        m_pixels = std::make_unique<QOpenGLFramebufferObject>(size, QOpenGLFramebufferObject::CombinedDepthStencil);
    m_view = view;
    m_spoilt = {};
}

QRect StillPicture::takeSpoilt()
{
    return std::exchange(m_spoilt, {});
}

}  // namespace ui::render
