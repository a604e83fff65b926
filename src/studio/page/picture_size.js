/// The size of a picture of the folder.

import {addressOf} from "./api.js";

/// The width and the height of a picture in pixels, or null where the browser cannot read it, as a TIFF.
export async function pictureSize(name) {
  const picture = new Image();
  picture.src = addressOf(name);
  try {
    await picture.decode();
    return {width: picture.naturalWidth, height: picture.naturalHeight};
  } catch {
    return null;
  }
}
