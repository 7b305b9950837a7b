"""The thesis' drawChanges (appendix B) as printed there, with its original cost.

Only two things are corrected: the misplaced `elif`, and the argument of `vstack`, which must now be a list.
"""
import copy

import cv2
import numpy as np


def draw_changes(color, change_mask, filter_min_blob_size_pixels=0, filter_blob_max_consolidation_distance_pixels=30):
    num_components, labels, stats, _ = cv2.connectedComponentsWithStats(change_mask, connectivity=8)
    sizes = stats[1:, -1]
    num_components -= 1
    diff_binary_filtered = np.zeros(change_mask.shape, dtype=np.uint8)
    for i in range(num_components):
        if sizes[i] >= filter_min_blob_size_pixels:
            diff_binary_filtered[labels == i + 1] = 255

    contours, _ = cv2.findContours(diff_binary_filtered, cv2.RETR_LIST, cv2.CHAIN_APPROX_SIMPLE)
    contour_img = copy.copy(color)

    def find_if_close(cnt1, cnt2):
        row1, row2 = cnt1.shape[0], cnt2.shape[0]
        for i in range(row1):
            for j in range(row2):
                dist = np.linalg.norm(cnt1[i] - cnt2[j])
                if abs(dist) < filter_blob_max_consolidation_distance_pixels:
                    return True
                elif i == row1 - 1 and j == row2 - 1:
                    return False

    length = len(contours)
    status = np.zeros((length, 1))
    for i, cnt1 in enumerate(contours):
        x = i
        if i != length - 1:
            for j, cnt2 in enumerate(contours[i + 1:]):
                x = x + 1
                dist = find_if_close(cnt1, cnt2)
                if dist == True:
                    val = min(status[i], status[x])
                    status[x] = status[i] = val
                else:
                    if status[x] == status[i]:
                        status[x] = i + 1

    unified = []
    for i in range(int(status.max()) + 1):
        pos = np.where(status == i)[0]
        if pos.size != 0:
            unified.append(cv2.convexHull(np.vstack([contours[k] for k in pos])))
    for contour in unified:
        x, y, w, h = cv2.boundingRect(contour)
        cv2.rectangle(contour_img, (x, y), (x + w, y + h), (0, 255, 0), 2)
    return contour_img
