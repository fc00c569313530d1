// SPDX-License-Identifier: GPL-3.0-or-later
in float vHeight;
in vec4 vColor;
in float vNumber;
layout(location = 0) out float oHeight;
layout(location = 1) out vec4 oPaint;
layout(location = 2) out float oNumber;

void main()
{
    oHeight = vHeight;
    oPaint = vColor;
    oNumber = vNumber;
}
